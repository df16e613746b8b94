// Test fixture that resolves one graph, given as text, with hand-made shaders and imports.
#pragma once

#include <gtest/gtest.h>

#include "graph/parse/parse.h"
#include "graph/resolve/resolve.h"
#include "graph/syntax/merge.h"
#include "tests/graph/samples/fake_shaders.h"

namespace weft::test {

inline ImportCatalog fake_imports() {
    ImportCatalog catalog;
    catalog.views = {"camera", "sun"};
    catalog.strides["Light"] = 48;
    const auto add = [&](const char* name, ImportKind kind) -> ImportDecl& {
        ImportDecl& import = catalog.imports[name];
        import.name = name;
        import.kind = kind;
        import.resource.name = name;
        import.resource.lifetime = ResourceLifetime::imported;
        import.resource.import = ImportState{};
        return import;
    };
    add("opaque", ImportKind::draw_list);
    add("masked", ImportKind::draw_list);
    ImportDecl& output = add("backbuffer", ImportKind::output);
    output.resource.format = Format::rgba8;
    ImportDecl& instances = add("instances", ImportKind::buffer);
    instances.resource.kind = ResourceKind::buffer;
    instances.resource.size_bytes = 6400;
    ImportDecl& noise = add("noise", ImportKind::image);
    noise.resource.format = Format::rgba8;
    noise.resource.extent = {64, 64, 1};
    noise.resource.import->entry.layout = Layout::shader_read_only;
    return catalog;
}

// Returns the profile of an imaginary device that supports all pipeline state and the usual features of each
// format. For example, sRGB formats do not support storage images, and integer formats do not support
// blending.
inline DeviceProfile fake_profile() {
    namespace ff = format_feature;
    DeviceProfile profile;
    profile.name = "fake";
    profile.non_solid_fill = profile.depth_clamp = profile.depth_bias_clamp = true;
    for (const std::string& name : format_names()) {
        const FormatInfo& info = format_info(*format_from_name(name));
        FormatFeatureMask mask =
            ff::kSampled | ff::kTransferSrc | ff::kTransferDst | ff::kBlitSrc | ff::kBlitDst;
        if (info.depth || info.stencil) {
            mask |= ff::kDepthAttachment;
        } else {
            mask |= ff::kColorAttachment;
            if (!info.srgb) mask |= ff::kStorage;
            if (info.numeric == NumericClass::float_like) mask |= ff::kSampledLinear | ff::kColorBlend;
        }
        profile.formats[info.format] = mask;
    }
    return profile;
}

class ResolveTest : public ::testing::Test {
 protected:
    // Parses a graph. `body` contains the members of the graph except "version" and "name". Its first line is
    // line 1 of the file "graph.json".
    static Result<GraphDesc> parsed(const std::string& body) {
        const std::string text = "{\"version\": 1, \"name\": \"test\"," + body + "}";
        const FileReader reader = [&](const std::string&) { return std::optional<std::string>(text); };
        Result<JsonDoc> document = read_json("graph.json", reader);
        if (!document) return document.take_errors();
        Result<JsonDoc> merged = merge(std::move(document).value());
        if (!merged) return merged.take_errors();
        return parse(*merged);
    }
    // Parses and resolves a graph.
    Result<ResolvedGraph> run(const std::string& body) {
        Result<GraphDesc> graph = parsed(body);
        if (!graph) return graph.take_errors();
        return resolve(
            {.graph = *graph,
             .passes = passes,
             .shaders = shaders,
             .imports = imports,
             .profile = profile,
             .request = {.params = params, .size = output_extent, .observed = observed, .exports = exports}},
            warnings);
    }

    ResolvedGraph good(const std::string& body) {
        Result<ResolvedGraph> graph = run(body);
        if (graph) return std::move(graph).value();
        ADD_FAILURE() << to_text(graph.errors());
        return {};
    }

    // Expects that resolve() reports exactly one error for the graph, and returns the error.
    Diagnostic bad(const std::string& body) {
        const Result<ResolvedGraph> graph = run(body);
        if (graph) {
            ADD_FAILURE() << "resolved, though it is wrong";
            return {};
        }
        EXPECT_EQ(graph.errors().size(), 1u) << to_text(graph.errors());
        return graph.errors().front();
    }

    static const PassDecl& pass_in(const ResolvedGraph& graph, const char* name) {
        static const PassDecl none;
        const PassId pass = find_pass(graph, name);
        if (pass != kNoId) return graph.passes[pass];
        ADD_FAILURE() << "no pass " << name;
        return none;
    }

    static const ResourceDecl& resource_in(const ResolvedGraph& graph, const char* name) {
        static const ResourceDecl none;
        const ResourceId resource = find_resource(graph, name);
        if (resource != kNoId) return graph.resources[resource];
        ADD_FAILURE() << "no resource " << name;
        return none;
    }

    static const UseDecl& use(const ResolvedGraph& graph, const char* pass, const char* port) {
        static const UseDecl none;
        for (const UseDecl& u : pass_in(graph, pass).uses) {
            if (u.port == port) return u;
        }
        ADD_FAILURE() << pass << " has no port " << port;
        return none;
    }

    // Returns the names of the passes that wrote the content that the port reads, such as "a b": one name for
    // each subresource range in the port's sources. Content from before the frame appears as "before".
    static std::string seen(const ResolvedGraph& graph, const char* pass, const char* port) {
        std::string text;
        for (const VersionSource& s : use(graph, pass, port).sources) {
            if (!text.empty()) text += " ";
            text += s.producer == kNoId ? "before" : graph.passes[s.producer].name;
        }
        return text;
    }

    static bool has_edge(const ResolvedGraph& graph, const char* from, const char* to, EdgeKind kind) {
        for (const EdgeDecl& e : graph.edges) {
            if (graph.passes[e.from].name == from && graph.passes[e.to].name == to && e.kind == kind)
                return true;
        }
        return false;
    }

    PassCatalog passes;
    ShaderCatalog shaders;
    ImportCatalog imports = fake_imports();
    DeviceProfile profile = fake_profile();
    std::map<std::string, double> params;
    Extent3D output_extent{640, 360, 1};
    std::vector<std::string> observed;
    std::map<std::string, ExportUse> exports;
    Diagnostics warnings;
};

inline void expect_help(const Diagnostic& d, const std::string& part) {
    for (const std::string& help : d.help) {
        if (help.find(part) != std::string::npos) return;
    }
    ADD_FAILURE() << "no help says " << part << ":\n" << to_text(d);
}

}  // namespace weft::test

// Test fixture for single stages of resolve(). It provides hand-made results of the earlier stages, so that a
// test calls one stage alone.
// Add resources and passes in alphabetical order, because their ids are indices into sorted lists.
#pragma once

#include <gtest/gtest.h>

#include <list>

#include "graph/parse/expression.h"
#include "graph/parse/reference.h"
#include "graph/resolve/version.h"
#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {

class StageTest : public ::testing::Test {
 protected:
    static Expr expression(const std::string& text) {
        return *parse_expression({.text = text, .literal = {}}, {});
    }
    static RefDesc reference(const std::string& text) {
        return *parse_reference({.text = text, .literal = {}}, {});
    }
    static PortDesc port(const std::string& name, const std::string& ref) {
        return {.port = name, .ref = reference(ref), .otherwise = {}, .sampler = {}, .loc = {}};
    }

    // Adds the description of an image, as input for evaluate(), shape_resources() and expand().
    ResourceDesc& describe_image(const std::string& name, const std::string& format = "rgba16f") {
        ResourceDesc& desc = graph.resources[name];
        desc.name = name;
        desc.formats = {format};
        return desc;
    }
    PassDesc& describe_pass(const std::string& name, const std::string& type = "compute") {
        PassDesc& desc = graph.passes[name];
        desc.name = name;
        desc.type = type;
        return desc;
    }

    // Adds an image of 16x16 px with its description, as if shape_resources() had made it.
    ResourceId add_image(const std::string& name, const std::string& format = "rgba16f") {
        ResourceDecl decl;
        decl.name = name;
        decl.format = format_from_name(format).value_or(Format::undefined);
        decl.extent = {16, 16, 1};
        shapes.resources.push_back(decl);
        shapes.origins.push_back({.desc = &describe_image(name, format)});
        shapes.suspects.shapes.push_back(0);
        shapes.suspects.writers.push_back(0);
        return static_cast<ResourceId>(shapes.resources.size() - 1);
    }

    // Adds a pass with its description, as if expand() had made it. The shader has the same name as the pass.
    PassId add_pass(const std::string& name, PassKind kind = PassKind::compute) {
        const auto id = static_cast<PassId>(expansion.passes.size());
        PassDraft draft;
        draft.decl.name = name;
        draft.decl.kind = kind;
        draft.desc = graph.passes.contains(name) ? &graph.passes[name] : &describe_pass(name);
        const auto shader = shaders.find(name);
        if (shader != shaders.end()) draft.shader = &shader->second.interface;
        expansion.passes.push_back(std::move(draft));
        expansion.instances[name] = {id};
        return id;
    }

    // Adds a use of a resource to the pass, as if bind() had made it.
    UseDecl& add_use(PassId pass, const std::string& port, ResourceId resource, Access access) {
        bound.resize(expansion.passes.size());
        UseDecl use;
        use.port = port;
        use.resource = resource;
        use.access = access;
        use.is_output = writes(access);
        bound[pass].uses.push_back(std::move(use));
        bound[pass].ports.emplace_back().desc = &described_ports.emplace_back(PortDesc{.port = port});
        return bound[pass].uses.back();
    }

    // Returns the suspects: the resources, passes and uses for which later stages report no follow-up errors.
    // Resources are suspect as in `shapes`. No pass and no use is suspect.
    Suspects suspects() {
        Suspects all = shapes.suspects;
        bound.resize(expansion.passes.size());
        all.passes.resize(expansion.passes.size());
        for (const BoundPass& pass : bound) all.uses.emplace_back(pass.uses.size());
        return all;
    }
    VersionedGraph versioned() {
        Suspects all = suspects();
        return {shapes.resources, bound, {}, std::move(all)};
    }

    // Returns the codes of the errors that the stage reported, such as "W104 W110".
    std::string codes() {
        errors = reporter.finish();
        std::string text;
        for (const Diagnostic& d : errors) text += (text.empty() ? "" : " ") + d.code;
        return text;
    }

    GraphDesc graph;
    PassCatalog passes;
    ShaderCatalog shaders;
    ImportCatalog imports = fake_imports();
    DeviceProfile profile = fake_profile();
    GraphLimits limits;
    std::map<std::string, double> params;
    std::vector<std::string> observed;
    Diagnostics warnings;
    Diagnostics errors;

    Values values = {.by_name = {{"output", size_value(64, 32)}}, .faulty = {}, .params = {}};
    Shapes shapes;
    Expansion expansion;
    std::vector<BoundPass> bound;
    std::list<PortDesc> described_ports;

    // Returns the input of a stage, made from the current fields of the fixture.
    ResolveInput input() {
        return {.graph = graph,
                .passes = passes,
                .shaders = shaders,
                .imports = imports,
                .profile = profile,
                .request = {.params = params, .size = {64, 32, 1}, .observed = observed},
                .limits = limits};
    }
    Reporter reporter{graph, limits.steps, warnings};
};

}  // namespace weft::test

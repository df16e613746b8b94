// Tests tables of textures: imports and resources whose textures a shader indexes.
#include <algorithm>

#include "tests/graph/resolve/resolve_fixture.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

// Returns an array of sampler2D; `count` 0: without a size.
ShaderBinding table_binding(const std::string& name, uint32_t count = 0) {
    ShaderBinding binding = sampled(name);
    binding.is_array = true;
    binding.is_runtime_array = count == 0;
    binding.count = std::max(1u, count);
    return binding;
}

ShaderProgram indexing(ShaderProgram program) {
    program.interface.needs_texture_tables = true;
    return program;
}

ShaderBinding changed(ShaderBinding binding, ImageDim dim, bool arrayed, bool shadow) {
    binding.dim = dim;
    binding.arrayed = arrayed;
    binding.shadow = shadow;
    return binding;
}

class ResolveTables : public ResolveTest {
 protected:
    ResolveTables() {
        profile.texture_table = 16;
        imports.imports["pictures"] = texture_table("pictures", 5);
        shaders["index.comp"] = indexing(with_params(compute({table_binding("pictures"), image_out("dst")}),
                                                     {member("picturesCount", 1, ScalarType::u32)}));
        shaders["sized.comp"] = compute({table_binding("pictures", 8), image_out("dst")});
        shaders["short.comp"] = compute({table_binding("pictures", 4), image_out("dst")});
        shaders["plain.comp"] = compute({sampled("pictures"), image_out("dst")});
        shaders["cubes.comp"] = indexing(
            compute({changed(table_binding("pictures"), ImageDim::cube, false, false), image_out("dst")}));
        shaders["layers.comp"] = indexing(
            compute({changed(table_binding("pictures"), ImageDim::d2, true, false), image_out("dst")}));
        shaders["shadow.comp"] = indexing(
            compute({changed(table_binding("pictures"), ImageDim::d2, false, true), image_out("dst")}));
        shaders["image.comp"] = compute({image_in("pictures"), image_out("dst")});
        shaders["none.comp"] = compute({image_out("dst")});
        ShaderBinding whole = table_binding("pictures");
        whole.numeric = NumericClass::uint;
        shaders["whole.comp"] = indexing(compute({whole, image_out("dst")}));
        shaders["count.comp"] =
            with_params(compute({image_out("dst")}), {member("picturesCount", 1, ScalarType::u32)});
        shaders["size.comp"] = indexing(
            with_params(compute({table_binding("pictures"), image_out("dst")}), {member("picturesSize", 2)}));
        shaders["draw.frag"] = fragment({"color"});
    }

    // Returns a graph in which pass "w" has the ports `in`; they are on line 2.
    static std::string sampling(const std::string& shader, const std::string& in = "[\"pictures\"]") {
        return R"j("imports": {"pictures": "textures", "noise": "image"}, "resources": {"x": "rgba16f"}, "passes": {
"w": {"type": "compute", "shader": ")j" +
               shader + R"j(", "out": {"dst": "x"}, "in": )j" + in +
               R"j(}, "r": {"type": "readback", "in": ["x"]}})j";
    }
    static std::string with_pass(const std::string& pass) {
        return R"j("imports": {"pictures": "textures"}, "resources": {"x": "rgba8"}, "passes": {"c": {"type": "clear", "out": ["x"]},
"p": )j" + pass +
               R"j(, "r": {"type": "readback", "in": ["x"]}})j";
    }
};

TEST_F(ResolveTables, APortIsOneSampledUseWithoutBarriers) {
    const ResolvedGraph g = good(sampling("index.comp"));
    const UseDecl& read = use(g, "w", "pictures");
    EXPECT_EQ(read.access, Access::sampled_read);
    EXPECT_EQ(read.binding, 0u);
    EXPECT_EQ(read.state.layout, Layout::shader_read_only);
    EXPECT_EQ(read.sampler.mip_filter, SamplerFilter::linear) << "the textures may have mips";
    const ResourceDecl& table = resource_in(g, "pictures");
    EXPECT_EQ(table.textures, 5u);
    EXPECT_EQ(table.lifetime, ResourceLifetime::imported);
    EXPECT_EQ(pass_in(g, "w").params.front().value[0], 5) << "Params.picturesCount";
    const FramePlan plan = compile(g, profile_needs(g, profile), {});
    const ResourceId id = find_resource(g, "pictures");
    for (const PassStep& step : plan.barriers.steps)
        for (const BarrierDecl& barrier : step.barriers) EXPECT_NE(barrier.resource, id);
    for (const BarrierDecl& barrier : plan.barriers.epilogue) EXPECT_NE(barrier.resource, id);
}

TEST_F(ResolveTables, AnArrayWithASizeNeedsNoFeatureForConstantIndices) {
    profile.texture_table = 0;
    EXPECT_EQ(use(good(sampling("sized.comp")), "w", "pictures").access, Access::sampled_read);
    shaders["sized.comp"].interface.needs_texture_tables = true;
    EXPECT_EQ(bad(sampling("sized.comp")).code, "W231");
}

TEST_F(ResolveTables, TheNumberOfTexturesIsAName) {
    const ResolvedGraph g = good(
        R"j("imports": {"pictures": "textures"}, "resources": {"x": {"format": "rgba16f", "size": ["picturesCount * 2", 3]}},
"passes": {"w": {"type": "compute", "shader": "count.comp", "out": {"dst": "x"}}, "r": {"type": "readback", "in": ["x"]}})j");
    EXPECT_EQ(resource_in(g, "x").extent.width, 10u);
    EXPECT_EQ(pass_in(g, "w").params.front().value[0], 5);
    EXPECT_TRUE(warnings.empty()) << to_text(warnings);
}

TEST_F(ResolveTables, ADeviceWithoutTablesIsNamedAtThePort) {
    profile.texture_table = 0;
    const Diagnostic error = bad(sampling("index.comp"));
    EXPECT_EQ(error.code, "W231");
    EXPECT_EQ(error.line, 2u);
    for (const char* part :
         {"port \"pictures\"", "pass \"w\"", "runtimeDescriptorArray",
          "shaderSampledImageArrayDynamicIndexing", "shaderSampledImageArrayNonUniformIndexing"})
        EXPECT_NE(error.message.find(part), std::string::npos) << error.message;
    expect_help(error, "descriptor set 2");
    expect_help(error, "\"textureTable\": 0");
}

TEST_F(ResolveTables, AShaderThatOnlyDeclaresTheFeatureIsRefusedToo) {
    profile.texture_table = 0;
    shaders["none.comp"].interface.needs_texture_tables = true;
    const Diagnostic error = bad(
        R"j("resources": {"x": "rgba16f"}, "passes": {"w": {"type": "compute", "shader": "none.comp", "out": {"dst": "x"}},
"r": {"type": "readback", "in": ["x"]}})j");
    EXPECT_EQ(error.code, "W231");
}

TEST_F(ResolveTables, AllTexturesOfAStageCount) {
    profile.texture_table = 5;
    EXPECT_EQ(resource_in(good(sampling("index.comp")), "pictures").textures, 5u);
    profile.texture_table = 4;
    const Diagnostic error = bad(sampling("index.comp"));
    EXPECT_EQ(error.code, "W231");
    EXPECT_EQ(error.line, 2u);
    EXPECT_NE(error.message.find("samples 5 textures"), std::string::npos) << error.message;
    EXPECT_NE(error.message.find("allows 4"), std::string::npos) << error.message;
    profile.texture_table = 5;
    shaders["both.comp"] = indexing(compute({table_binding("pictures"), sampled("noise"), image_out("dst")}));
    EXPECT_EQ(bad(sampling("both.comp", R"(["pictures", "noise"])")).code, "W231");
}

struct BadTable {
    const char* name;
    const char* shader;
    const char* in;
    const char* code;
    const char* message;
};
void PrintTo(const BadTable& bad, std::ostream* out) {
    *out << bad.name;
}
class ResolveBadTable : public ResolveTables, public testing::WithParamInterface<BadTable> {};

TEST_P(ResolveBadTable, IsRefusedAtThePort) {
    const BadTable& b = GetParam();
    const Diagnostic error = bad(sampling(b.shader, b.in));
    EXPECT_EQ(error.code, b.code);
    EXPECT_EQ(error.line, 2u) << error.message;
    EXPECT_NE(error.message.find(b.message), std::string::npos) << error.message;
    EXPECT_FALSE(error.help.empty());
}

constexpr const char* kTable = "[\"pictures\"]";
INSTANTIATE_TEST_SUITE_P(
    All, ResolveBadTable,
    testing::Values(
        BadTable{"plain", "plain.comp", kTable, "W232", "something else than an array of sampler2D"},
        BadTable{"cubes", "cubes.comp", kTable, "W232", "something else than an array of sampler2D"},
        BadTable{"layers", "layers.comp", kTable, "W232", "something else than an array of sampler2D"},
        BadTable{"shadow", "shadow.comp", kTable, "W232", "something else than an array of sampler2D"},
        BadTable{"storage", "image.comp", kTable, "W232", "something else than an array of sampler2D"},
        BadTable{"short_array", "short.comp", kTable, "W232", "has only 4 elements for its 5 textures"},
        BadTable{"each", "index.comp", R"({"pictures": {"ref": "pictures", "each": "mip"}})", "W232",
                 "has \"each\""},
        BadTable{"image", "index.comp", R"({"pictures": "noise"})", "W232", "is no table of textures"},
        BadTable{"numbers", "whole.comp", kTable, "W172", "expects uint values"},
        BadTable{"no_binding", "none.comp", kTable, "W170", "has no binding"}),
    [](const auto& row) { return row.param.name; });

TEST_F(ResolveTables, OnlyShadersSampleThem) {
    for (const char* pass :
         {R"({"type": "copy", "in": {"src": "pictures"}, "out": {"dst": "x"}, "partial": true})",
          R"({"type": "blit", "in": {"src": "pictures"}, "out": {"dst": "x"}, "partial": true})",
          R"({"type": "readback", "in": ["pictures"]})"}) {
        const Diagnostic error = bad(with_pass(pass));
        EXPECT_EQ(error.code, "W232") << pass;
        EXPECT_NE(error.message.find("cannot use tables"), std::string::npos) << error.message;
    }
}

TEST_F(ResolveTables, NoPassWritesThem) {
    for (const char* pass :
         {R"({"type": "clear", "out": ["pictures"]})",
          R"({"type": "compute", "shader": "none.comp", "out": {"dst": "pictures"}})",
          R"({"type": "fullscreen", "shader": "draw.frag", "out": {"color": "pictures"}})"}) {
        EXPECT_EQ(bad(with_pass(pass)).code, "W232") << pass;
    }
}

TEST_F(ResolveTables, ItsSizeIsUnknown) {
    const Diagnostic error = bad(sampling("size.comp"));
    EXPECT_NE(error.message.find("Params.picturesSize"), std::string::npos) << error.message;
}

TEST_F(ResolveTables, TheKindMustBeNamed) {
    const Diagnostic error =
        bad(R"j("imports": {"pictures": "image"}, "resources": {"x": "rgba16f"}, "passes": {
"w": {"type": "compute", "shader": "none.comp", "out": {"dst": "x"}}, "r": {"type": "readback", "in": ["x"]}})j");
    EXPECT_EQ(error.code, "W118");
    expect_help(error, "\"textures\"");
}

TEST_F(ResolveTables, AnErrorOfTheImportIsTheOnlyOne) {
    for (const char* name : {"pictures", "nothing"}) {
        const std::string text = std::string(R"j("imports": {")j") + name +
                                 R"j(": "textures"}, "resources": {"x": {"format": "rgba16f", "size": [")j" +
                                 name +
                                 R"j(Count", 8]}}, "passes": {
"w": {"type": "compute", "shader": "index.comp", "out": {"dst": "x"}, "in": {"pictures": ")j" +
                                 name + R"j("}}, "r": {"type": "readback", "in": ["x"]}})j";
        imports.imports["pictures"].kind = ImportKind::image;
        EXPECT_EQ(bad(text).code, "W118") << name;
    }
}

TEST_F(ResolveTables, TheProgramCannotExportATable) {
    Result<GraphDesc> graph = parsed(
        R"j("resources": {"own": {"format": "rgba8", "textures": ["a.png"]}, "x": "rgba16f"}, "passes": {
"w": {"type": "compute", "shader": "index.comp", "out": {"dst": "x"}, "in": {"pictures": "own"}}, "r": {"type": "readback", "in": ["x"]}})j");
    ASSERT_TRUE(graph) << to_text(graph.errors());
    FileDesc& file = graph->resources.at("own").textures.front();
    file.path = "/files/a.png";
    file.width_px = file.height_px = 4;
    for (const bool exported : {false, true}) {
        GraphRequest request{.size = output_extent};
        if (exported) request.exports["own"] = {};
        const Result<ResolvedGraph> resolved = resolve({.graph = *graph,
                                                        .passes = passes,
                                                        .shaders = shaders,
                                                        .imports = imports,
                                                        .profile = profile,
                                                        .request = request},
                                                       warnings);
        ASSERT_EQ(static_cast<bool>(resolved), !exported);
        if (resolved) continue;
        ASSERT_EQ(resolved.errors().size(), 1u) << to_text(resolved.errors());
        EXPECT_EQ(resolved.errors().front().code, "W243");
        expect_help(resolved.errors().front(), "copy");
    }
}

}  // namespace
}  // namespace weft::test

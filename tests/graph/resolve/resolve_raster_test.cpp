// Tests passes that draw: the locations, first writes, blending, depth and extents of their attachments, and
// their draw lists and views.
#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

class ResolveRaster : public ResolveTest {
 protected:
    ResolveRaster() {
        shaders["gbuffer"] = fragment({"normal", "albedo"});
        shaders["mesh"] = fragment({"hdr"});
        shaders["sky.frag"] = fragment({"hdr"}, {sampled("depth")});
        shaders["full.frag"] = fragment({"hdr"});
        shaders["none"] = fragment({});
    }
    static std::string raster(const std::string& keys) {
        return R"j({"type": "raster", "draws": ["opaque"], )j" + keys + "}";
    }
    std::string graph(const std::string& resources, const std::string& pass_list) {
        return R"j("imports": {"opaque": "drawlist", "masked": "drawlist", "instances": "buffer"},
          "resources": {)j" +
               resources + R"j(}, "passes": {)j" + pass_list + "}";
    }
};

const std::string kHdrDepth = R"j("hdr": "rgba16f", "depth": "d32f")j";

TEST_F(ResolveRaster, ColoursByLocationAndDepthCleared) {
    const ResolvedGraph g = good(graph(
        R"j("albedo": "rgba8_srgb", "normal": "rg16f", "depth": "d32f")j",
        R"j("g": )j" + raster(R"j("shader": "gbuffer", "depth": "depth", "out": ["albedo", "normal"])j")));
    const PassDecl& pass = pass_in(g, "g");
    ASSERT_EQ(pass.colors.size(), 2u);
    EXPECT_EQ(pass.uses[pass.colors[0].use].port, "normal");
    EXPECT_EQ(pass.uses[pass.colors[1].use].port, "albedo");
    EXPECT_EQ(pass.uses[pass.colors[0].use].access, Access::color_write);
    EXPECT_FALSE(pass.colors[0].covers);
    ASSERT_TRUE(pass.depth);
    EXPECT_EQ(pass.uses[pass.depth->use].access, Access::depth_write);
    EXPECT_EQ(pass.uses[pass.depth->use].range.aspects, aspect::kDepth);
    EXPECT_EQ(pass.render_extent, (Extent3D{640, 360, 1}));
    EXPECT_EQ(pass.draw_lists, std::vector<std::string>{"opaque"});
    EXPECT_EQ(pass.view, "camera");
}

TEST_F(ResolveRaster, SecondPassLoadsAndDepthIsTestedOnly) {
    const ResolvedGraph g = good(
        graph(kHdrDepth, R"j("a": )j" + raster(R"j("shader": "mesh", "depth": "depth", "out": ["hdr"])j") +
                             R"j(, "b": )j" +
                             raster(R"j("shader": "mesh", "depth": "depth", "out": ["hdr"], "after": ["a"],
                                           "state": {"depth": "greater", "blend": "add"})j")));
    EXPECT_EQ(use(g, "a", "hdr").access, Access::color_write);
    EXPECT_EQ(use(g, "b", "hdr").access, Access::color_read_write);
    EXPECT_EQ(seen(g, "b", "hdr"), "a");
    EXPECT_EQ(use(g, "b", "depth").access, Access::depth_read);
    EXPECT_EQ(seen(g, "b", "depth"), "a");
    EXPECT_EQ(use(g, "b", "depth").state.layout, Layout::depth_read_only);
    EXPECT_TRUE(pass_in(g, "b").colors[0].blend.enabled);
}

TEST_F(ResolveRaster, BlendOfNothingClears) {
    const ResolvedGraph g = good(
        graph(R"j("hdr": {"format": "rgba16f", "clear": [0, 0, 0, 1]})j",
              R"j("a": )j" + raster(R"j("shader": "mesh", "out": ["hdr"], "state": {"blend": "add"})j")));
    EXPECT_EQ(use(g, "a", "hdr").access, Access::color_write);
    EXPECT_EQ(pass_in(g, "a").colors[0].clear, (std::array<float, 4>{0, 0, 0, 1}));
    EXPECT_FALSE(pass_in(g, "a").colors[0].covers);
}

TEST_F(ResolveRaster, FullscreenCoversUnlessItDiscards) {
    const std::string body = graph(R"j("hdr": "rgba16f")j",
                                   R"j("a": {"type": "fullscreen", "shader": "full.frag", "out": ["hdr"]})j");
    EXPECT_TRUE(pass_in(good(body), "a").colors[0].covers);
    shaders["full.frag"].interface.discards = true;
    EXPECT_FALSE(pass_in(good(body), "a").colors[0].covers);
}

TEST_F(ResolveRaster, DepthMayBeTestedAndSampledAtOnce) {
    const std::string first =
        R"j("a": )j" + raster(R"j("shader": "mesh", "depth": "depth", "out": ["hdr"])j");
    const auto sky = [&](const std::string& test) {
        return graph(kHdrDepth,
                     first + R"j(, "s": {"type": "fullscreen", "shader": "sky.frag", "in": {"depth": "depth"},
          "depth": {"ref": "depth"}, "out": ["hdr"], "after": ["a"], "state": {"depth": ")j" +
                         test + R"j("}})j");
    };
    const Result<ResolvedGraph> g = run(sky("equal"));
    if (!g) FAIL() << to_text(g.errors());
    EXPECT_EQ(pass_in(*g, "s").uses.size(), 3u);
    const Diagnostic d = bad(sky("equal_write"));
    EXPECT_EQ(d.code, "W163");
    EXPECT_NE(d.message.find("different layouts"), std::string::npos);
}

TEST_F(ResolveRaster, SampledDepthFiltersNearest) {
    shaders["sky.frag"].interface.bindings[0].stages = stage_bit(ShaderStage::fragment);
    const ResolvedGraph g = good(graph(
        kHdrDepth + R"j(, "out": "rgba16f")j",
        R"j("a": )j" + raster(R"j("shader": "mesh", "depth": "depth", "out": ["hdr"])j") +
            R"j(, "s": {"type": "fullscreen", "shader": "sky.frag", "in": ["depth"], "out": {"hdr": "out"}})j"));
    EXPECT_EQ(use(g, "s", "depth").sampler.filter, SamplerFilter::nearest);
    EXPECT_EQ(use(g, "s", "depth").state.layout, Layout::depth_read_only);
}

TEST_F(ResolveRaster, TwoUnorderedRasterWriters) {
    const Diagnostic d = bad(
        graph(R"j("hdr": "rgba16f")j", R"j("a": )j" + raster(R"j("shader": "mesh", "out": ["hdr"])j") +
                                           R"j(, "b": )j" + raster(R"j("shader": "mesh", "out": ["hdr"])j")));
    EXPECT_EQ(d.code, "W111");
}

TEST_F(ResolveRaster, AttachmentsMustAgreeInSize) {
    const Diagnostic d =
        bad(graph(R"j("albedo": "rgba8", "normal": {"format": "rg16f", "size": "output / 2"})j",
                  R"j("g": )j" + raster(R"j("shader": "gbuffer", "out": ["albedo", "normal"])j")));
    EXPECT_EQ(d.code, "W174");
    EXPECT_NE(d.message.find("320x180"), std::string::npos) << d.message;
}

TEST_F(ResolveRaster, AttachmentIsOneMip) {
    const Diagnostic d = bad(graph(R"j("hdr": {"format": "rgba16f", "mips": 2})j",
                                   R"j("a": )j" + raster(R"j("shader": "mesh", "out": ["hdr"])j")));
    EXPECT_EQ(d.code, "W169");
    expect_help(d, "hdr.mip(0)");
}

TEST_F(ResolveRaster, OutputWithoutPort) {
    const Diagnostic d = bad(graph(R"j("albedo": "rgba8")j",
                                   R"j("g": )j" + raster(R"j("shader": "gbuffer", "out": ["albedo"])j")));
    EXPECT_EQ(d.code, "W171");
    EXPECT_NE(d.message.find(R"j(writes "normal")j"), std::string::npos) << d.message;
}

TEST_F(ResolveRaster, DepthNeedsADepthFormat) {
    const Diagnostic d =
        bad(graph(R"j("hdr": "rgba16f", "depth": "r32f")j",
                  R"j("a": )j" + raster(R"j("shader": "mesh", "depth": "depth", "out": ["hdr"])j")));
    EXPECT_EQ(d.code, "W117");
}

TEST_F(ResolveRaster, IntegerImageForAFloatOutput) {
    const Diagnostic d =
        bad(graph(R"j("hdr": "rgba32u")j", R"j("a": )j" + raster(R"j("shader": "mesh", "out": ["hdr"])j")));
    EXPECT_EQ(d.code, "W172");
}

TEST_F(ResolveRaster, DrawListsAndViews) {
    const auto body = [&](const std::string& draws, const std::string& view) {
        return graph(R"j("hdr": "rgba16f")j",
                     R"j("a": {"type": "raster", "shader": "mesh", "out": ["hdr"], "draws": )j" + draws +
                         R"j(, "view": ")j" + view + R"j("})j");
    };
    const Diagnostic slip = bad(body(R"j(["opaqe"])j", "camera"));
    EXPECT_EQ(slip.code, "W118");
    expect_help(slip, "did you mean \"opaque\"");
    EXPECT_EQ(bad(body(R"j(["instances"])j", "camera")).code, "W118");
    const Diagnostic view = bad(body(R"j(["opaque"])j", "camra"));
    EXPECT_EQ(view.code, "W118");
    expect_help(view, "did you mean \"camera\"");
    EXPECT_EQ(pass_in(good(body(R"j(["opaque", "masked"])j", "sun")), "a").view, "sun");
}

TEST_F(ResolveRaster, VertexInputsComeFromTheDrawList) {
    imports.imports["opaque"].vertex_format.attributes = {{.name = "position"}, {.name = "normal"}};
    StageVariable input;
    input.name = "postion";
    shaders["mesh"].interface.vertex_inputs = {input};
    const Diagnostic d =
        bad(graph(R"j("hdr": "rgba16f")j", R"j("a": )j" + raster(R"j("shader": "mesh", "out": ["hdr"])j")));
    EXPECT_EQ(d.code, "W167");
    expect_help(d, "did you mean \"position\"");
}

TEST_F(ResolveRaster, VertexInputsHaveTheNumberClassOfTheDrawList) {
    const std::string body =
        graph(R"j("hdr": "rgba16f")j", R"j("a": )j" + raster(R"j("shader": "mesh", "out": ["hdr"])j"));
    const std::map<Format, ScalarType> types{{Format::rgb32f, ScalarType::f32},
                                             {Format::rgba8, ScalarType::f32},
                                             {Format::rgb32u, ScalarType::u32},
                                             {Format::rgb32i, ScalarType::i32}};
    for (const auto& [format, right] : types) {
        imports.imports["opaque"].vertex_format.attributes = {{.name = "position", .format = format}};
        for (const ScalarType scalar : {ScalarType::f32, ScalarType::u32, ScalarType::i32}) {
            StageVariable input;
            input.name = "position";
            input.scalar = scalar;
            shaders["mesh"].interface.vertex_inputs = {input};
            if (scalar == right) {
                good(body);
                continue;
            }
            const Diagnostic d = bad(body);
            EXPECT_EQ(d.code, "W167");
            expect_help(d, "float, uint or int");
        }
    }
}

TEST_F(ResolveRaster, DeferredShape) {
    // The lighting pass modifies hdr in place. It must run after the G-buffer pass, because it also reads the
    // G-buffer output `albedo`.
    shaders["gb"] = fragment({"albedo", "hdr"});
    shaders["light.comp"] = compute({sampled("albedo"), image_in_out("hdr")});
    const ResolvedGraph g = good(graph(
        R"j("albedo": "rgba8", "hdr": "rgba16f")j",
        R"j("g": )j" + raster(R"j("shader": "gb", "out": ["albedo", "hdr"])j") +
            R"j(, "light": {"type": "compute", "shader": "light.comp", "in": ["albedo"], "out": ["hdr"]})j"));
    EXPECT_EQ(use(g, "light", "hdr").access, Access::storage_read_write);
    EXPECT_EQ(seen(g, "light", "hdr"), "g");
    EXPECT_EQ(pass_in(g, "light").groups, (std::array<uint32_t, 3>{80, 45, 1}));
}

}  // namespace
}  // namespace weft::test

// Tests cube, array, 3D and multisampled images, resolves of attachments, blits, indirect dispatches and
// indirect draws.
#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

class ResolveKinds : public ResolveTest {
 protected:
    ResolveKinds() {
        shaders["make.comp"] = compute({image_out("dst")});
        shaders["copy.comp"] = compute({sampled("src"), image_out("dst")});
        shaders["draw"] = fragment({"color"});
    }

    std::string image(const std::string& keys, const std::string& format = "rgba16f") {
        return R"j("resources": {
"x": {"format": ")j" +
               format + R"j(", )j" + keys + R"j(}}, "passes": {"c": {"type": "clear", "out": ["x"]}})j";
    }
    // Returns a graph in which pass "draw" draws into the image "ms" and resolves "ms" into the image "one".
    // `ms` and `one` contain the members of these images, and `more` contains further passes.
    std::string resolving(const std::string& ms, const std::string& one, const std::string& more = "") {
        return R"j("imports": {"opaque": "drawlist"}, "resources": {
"ms": {)j" + ms +
               R"j(},
"one": {)j" + one +
               R"j(}}, "passes": {
"draw": {"type": "raster", "draws": ["opaque"], "shader": "draw", "out": {"color": "ms"},
  "resolve": {"one": "color"}})j" +
               more + "}";
    }
    static std::string ms() { return R"j("format": "rgba16f", "samples": 4)j"; }
};

TEST_F(ResolveKinds, Cubes) {
    const ResolvedGraph g = good(image(R"j("cube": 128, "mips": 7)j"));
    EXPECT_EQ(g.resources[0].image_kind, ImageKind::cube);
    EXPECT_EQ(g.resources[0].extent, (Extent3D{128, 128, 1}));
    EXPECT_EQ(g.resources[0].layers, 6u);
    EXPECT_EQ(g.resources[0].mips, 7u);
    const ResolvedGraph several = good(image(R"j("kind": "cubeArray", "size": 16, "layers": 3)j"));
    EXPECT_EQ(several.resources[0].image_kind, ImageKind::cube_array);
    EXPECT_EQ(several.resources[0].layers, 18u);
    const Diagnostic d = bad(image(R"j("kind": "cube")j"));
    EXPECT_EQ(d.code, "W109");
    EXPECT_EQ(d.line, 2u);
    expect_help(d, R"j("size": 128)j");
}

TEST_F(ResolveKinds, ArraysAndVolumes) {
    const ResolvedGraph one = good(image(R"j("kind": "array")j"));
    EXPECT_EQ(one.resources[0].image_kind, ImageKind::d2_array);
    EXPECT_EQ(one.resources[0].layers, 1u);
    const ResolvedGraph fog =
        good(image(R"j("kind": "3d", "size": [64, 32], "depth": "16 * 8", "mips": "full")j"));
    EXPECT_EQ(fog.resources[0].image_kind, ImageKind::d3);
    EXPECT_EQ(fog.resources[0].extent, (Extent3D{64, 32, 128}));
    EXPECT_EQ(fog.resources[0].layers, 1u);
    EXPECT_EQ(fog.resources[0].mips, 8u);
    EXPECT_EQ(bad(image(R"j("kind": "3d", "depth": 4)j", "d32f")).code, "W109");
}

TEST_F(ResolveKinds, BindingsKnowTheKinds) {
    const auto body = [](const std::string& keys, const std::string& ref) {
        return R"j("resources": {"y": "rgba16f", "x": {"format": "rgba16f", )j" + keys + R"j(}}, "passes": {
          "c": {"type": "clear", "out": ["x"]},
          "r": {"type": "compute", "shader": "copy.comp", "in": {"src": ")j" +
               ref + R"j("}, "out": {"dst": "y"}}})j";
    };
    EXPECT_EQ(bad(body(R"j("cube": 64)j", "x")).code, "W173");
    good(body(R"j("cube": 64)j", "x.layer(2)"));
    shaders["copy.comp"].interface.bindings[0].dim = ImageDim::cube;
    good(body(R"j("cube": 64)j", "x"));
    good(body(R"j("kind": "cubeArray", "size": 64, "layers": 2)j", "x.layer(6..11)"));
    EXPECT_EQ(bad(body(R"j("layers": 6)j", "x")).code, "W173");
    shaders["copy.comp"].interface.bindings[0].dim = ImageDim::d3;
    good(body(R"j("kind": "3d", "size": 64, "depth": 4)j", "x"));
    EXPECT_EQ(bad(body(R"j("cube": 64)j", "x")).code, "W173");
}

TEST_F(ResolveKinds, VolumesAreNoAttachments) {
    const Diagnostic d =
        bad(R"j("resources": {"x": {"format": "rgba16f", "kind": "3d", "depth": 4}}, "passes": {
      "f": {"type": "fullscreen", "shader": "draw", "out": {"color": "x"}}})j");
    EXPECT_EQ(d.code, "W169");
    expect_help(d, "compute pass");
}

TEST_F(ResolveKinds, MultisampledImagesAreNoStorage) {
    const Diagnostic d = bad(R"j("resources": {"x": {"format": "rgba16f", "samples": 4}}, "passes": {
      "m": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}}})j");
    EXPECT_EQ(d.code, "W173");
    expect_help(d, "resolve the image first");
}

TEST_F(ResolveKinds, AttachmentsAreResolvedWhenThePassEnds) {
    const ResolvedGraph g = good(resolving(ms(), R"j("format": "rgba16f")j", R"j(,
"show": {"type": "readback", "in": ["one"]})j"));
    const PassDecl& draw = pass_in(g, "draw");
    ASSERT_EQ(draw.colors.size(), 1u);
    ASSERT_NE(draw.colors[0].resolve_use, kNoId);
    const UseDecl& target = draw.uses[draw.colors[0].resolve_use];
    EXPECT_EQ(g.resources[target.resource].name, "one");
    EXPECT_EQ(target.access, Access::color_write);
    EXPECT_EQ(target.state.stages, stage::kColorOutput);
    EXPECT_EQ(target.state.layout, Layout::color_attachment);
    EXPECT_TRUE(target.is_output);
    EXPECT_EQ(resource_in(g, "one").usage & usage::kColorAttachment, usage::kColorAttachment);
    EXPECT_EQ(seen(g, "show", "one"), "draw");
}

TEST_F(ResolveKinds, AResolveNeedsEqualEnds) {
    const std::string one = R"j("format": "rgba16f")j";
    EXPECT_EQ(bad(resolving(one, one)).code, "W179");
    expect_help(bad(resolving(one, one)), R"j("samples": 4)j");
    EXPECT_EQ(bad(resolving(ms(), ms())).code, "W179");
    const Diagnostic format = bad(resolving(ms(), R"j("format": "rgba8")j"));
    EXPECT_EQ(format.code, "W179");
    EXPECT_EQ(format.line, 5u);
    expect_help(format, "same format");
    const Diagnostic size = bad(resolving(ms(), R"j("format": "rgba16f", "size": "output / 2")j"));
    EXPECT_EQ(size.code, "W179");
    EXPECT_NE(size.message.find("640x360 and 320x180"), std::string::npos) << size.message;
}

TEST_F(ResolveKinds, Blits) {
    const auto body = [](const std::string& x, const std::string& y, const std::string& src = R"j("x")j") {
        return R"j("resources": {"x": {)j" + x + R"j(}, "y": {)j" + y + R"j(}}, "passes": {
"c": {"type": "clear", "out": ["x"]},
"b": {"type": "blit", "in": {"src": )j" +
               src + R"j(}, "out": {"dst": "y"}}})j";
    };
    const std::string half = R"j("format": "rgba8", "size": "output / 2")j";
    const ResolvedGraph g = good(body(R"j("format": "rgba16f")j", half));
    EXPECT_EQ(use(g, "b", "src").access, Access::blit_read);
    EXPECT_EQ(use(g, "b", "src").sampler.filter, SamplerFilter::linear);
    EXPECT_EQ(use(g, "b", "dst").access, Access::blit_write);
    EXPECT_EQ(use(g, "b", "dst").state.stages, stage::kBlit);
    const ResolvedGraph ints = good(body(R"j("format": "r32u")j", R"j("format": "r16u")j"));
    EXPECT_EQ(use(ints, "b", "src").sampler.filter, SamplerFilter::nearest);
    EXPECT_EQ(bad(body(R"j("format": "r32u")j", half)).code, "W183");
    EXPECT_EQ(bad(body(R"j("format": "rgba16f", "mips": 3)j", half)).code, "W183");
    EXPECT_EQ(bad(body(ms(), half)).code, "W183");
    EXPECT_EQ(bad(body(R"j("format": "r32u")j", R"j("format": "r16u")j",
                       R"j({"ref": "x", "sampler": {"filter": "linear"}})j"))
                  .code,
              "W117");
    profile.formats[Format::rgba8] &= ~format_feature::kBlitDst;
    const Diagnostic d = bad(body(R"j("format": "rgba16f")j", half));
    EXPECT_EQ(d.code, "W117");
    expect_help(d, "use as a blit target");
}

TEST_F(ResolveKinds, IndirectDispatches) {
    const auto body = [](const std::string& args) {
        return R"j("resources": {"y": "rgba16f", "args": {)j" + args + R"j(}}, "passes": {
"c": {"type": "clear", "out": ["args"]},
"d": {"type": "compute", "shader": "make.comp", "groups": {"indirect": "args"}, "out": {"dst": "y"}}})j";
    };
    const ResolvedGraph g = good(body(R"j("buffer": "u32", "count": 3)j"));
    const PassDecl& d = pass_in(g, "d");
    ASSERT_NE(d.indirect_use, kNoId);
    const UseDecl& args = d.uses[d.indirect_use];
    EXPECT_EQ(args.access, Access::indirect_read);
    EXPECT_EQ(args.state.stages, stage::kDrawIndirect);
    EXPECT_EQ(args.binding, kNoId);
    EXPECT_EQ(d.groups, (std::array<uint32_t, 3>{0, 0, 0}));
    EXPECT_EQ(seen(g, "d", "indirect"), "c");
    EXPECT_TRUE(resource_in(g, "args").usage & usage::kIndirect);
    EXPECT_EQ(bad(body(R"j("buffer": "u32", "count": 2)j")).code, "W114");
    EXPECT_EQ(bad(body(R"j("format": "r32u")j")).code, "W114");
}

TEST_F(ResolveKinds, IntegersAreResolvedAndDepthIsNot) {
    profile.integer_samples = 1 | 4;
    shaders["draw"].interface.fragment_outputs[0].scalar = ScalarType::u32;
    good(resolving(R"j("format": "r32u", "samples": 4)j", R"j("format": "r32u")j"));
    shaders["draw"].interface.fragment_outputs[0].scalar = ScalarType::f32;
    const Diagnostic d = bad(R"j("imports": {"opaque": "drawlist"}, "resources": {
"ms": {"format": "rgba16f", "samples": 4}, "z": {"format": "d32f", "samples": 4}, "one": "d32f"}, "passes": {
"draw": {"type": "raster", "draws": ["opaque"], "shader": "draw", "out": {"color": "ms"}, "depth": "z",
  "resolve": {"one": "depth"}}})j");
    EXPECT_EQ(d.code, "W109");
    EXPECT_EQ(d.line, 4u);
}

TEST_F(ResolveKinds, SampleCountsAreTheDevices) {
    const auto body = [](const std::string& format, uint32_t samples) {
        return R"j("imports": {"opaque": "drawlist"}, "resources": {
"ms": {"format": ")j" +
               format + R"j(", "samples": )j" + std::to_string(samples) + R"j(}}, "passes": {
"draw": {"type": "raster", "draws": ["opaque"], "shader": "draw", "out": {"color": "ms"}}})j";
    };
    profile.color_samples = 1 | 2 | 8;
    good(body("rgba16f", 1));
    good(body("rgba16f", 2));
    good(body("rgba16f", 8));
    const Diagnostic d = bad(body("rgba16f", 4));
    EXPECT_EQ(d.code, "W119");
    EXPECT_EQ(d.line, 2u);
    EXPECT_NE(d.message.find("\"ms\" has 4 samples; the device supports 1, 2, 8 for \"rgba16f\""),
              std::string::npos)
        << d.message;
    expect_help(d, "choose one of these numbers");
    expect_help(d, "\"fake\"");
    profile.color_samples = 1;
    expect_help(bad(body("rgba16f", 2)), "remove \"samples\"");
    profile.color_samples = 1 | 2;
    profile.depth_samples = 1 | 4;
    EXPECT_EQ(bad(R"j("resources": {"z": {"format": "d32f", "samples": 2}}, "passes": {
"c": {"type": "clear", "out": ["z"]}})j")
                  .code,
              "W119");
}

class ResolveIndirectDraws : public ResolveKinds {
 protected:
    ResolveIndirectDraws() {
        imports.imports.at("opaque").draws = 3;
        imports.strides["DrawCommand"] = 20;
    }
    static std::string body(const std::string& commands) {
        return R"j("imports": {"opaque": "drawlist", "masked": "drawlist"}, "resources": {
"x": "rgba16f", "commands": {)j" +
               commands + R"j(}}, "passes": {
"c": {"type": "clear", "out": ["commands"]},
"d": {"type": "raster", "shader": "draw", "draws": {"list": "opaque", "indirect": "commands"},
  "out": {"color": "x"}}})j";
    }
};

TEST_F(ResolveIndirectDraws, ReadTheirCommandsFromABuffer) {
    const ResolvedGraph g = good(body(R"j("buffer": "DrawCommand", "count": "opaqueDraws")j"));
    EXPECT_EQ(resource_in(g, "commands").size_bytes, 60u);
    EXPECT_TRUE(resource_in(g, "commands").usage & usage::kIndirect);
    const PassDecl& d = pass_in(g, "d");
    EXPECT_EQ(d.draw_lists, std::vector<std::string>{"opaque"});
    EXPECT_EQ(d.indirect_use, kNoId);
    ASSERT_NE(d.draw_commands_use, kNoId);
    const UseDecl& commands = d.uses[d.draw_commands_use];
    EXPECT_EQ(commands.access, Access::indirect_read);
    EXPECT_EQ(commands.state.stages, stage::kDrawIndirect);
    EXPECT_EQ(commands.binding, kNoId);
    EXPECT_EQ(seen(g, "d", "indirect"), "c");
    EXPECT_EQ(pass_in(good(resolving(ms(), R"j("format": "rgba16f")j")), "draw").draw_commands_use, kNoId);
}

TEST_F(ResolveIndirectDraws, NeedACommandForEachDraw) {
    good(body(R"j("buffer": "u32", "count": 15)j"));
    const Diagnostic small = bad(body(R"j("buffer": "u32", "count": 14)j"));
    EXPECT_EQ(small.code, "W114");
    EXPECT_EQ(small.line, 4u);
    EXPECT_NE(small.message.find("has 56 bytes, but the 3 draws of \"opaque\" need 60"), std::string::npos)
        << small.message;
    expect_help(small, "opaqueDraws");
    EXPECT_EQ(bad(body(R"j("format": "rgba8")j")).code, "W114");
}

TEST_F(ResolveIndirectDraws, ListsCountTheirDrawsInExpressionsAndParams) {
    shaders["make.comp"] =
        with_params(compute({image_out("dst")}), {member("opaqueDraws", 1, ScalarType::u32)});
    const auto graph = [](const std::string& more) {
        return R"j("imports": {"opaque": "drawlist"}, "resources": {"x": "rgba16f"}, )j" + more +
               R"j( "passes": {
"m": {"type": "compute", "shader": "make.comp", "groups": "opaqueDraws + 4", "out": {"dst": "x"}}})j";
    };
    const ResolvedGraph g = good(graph(""));
    EXPECT_EQ(pass_in(g, "m").groups[0], 7u);
    ASSERT_EQ(pass_in(g, "m").params.size(), 1u);
    EXPECT_EQ(pass_in(g, "m").params[0].value[0], 3.0);
    // A constant that the author declares takes precedence over a built-in name such as `opaqueDraws`.
    EXPECT_EQ(pass_in(good(graph(R"j("consts": {"opaqueDraws": 20},)j")), "m").groups[0], 24u);
}

}  // namespace
}  // namespace weft::test

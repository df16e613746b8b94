// Tests that ports fit the shaders, and tests `Params` blocks, dispatch sizes and C++ passes.
#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

class ResolveInterface : public ResolveTest {
 protected:
    ResolveInterface() {
        shaders["make.comp"] = compute({image_out("dst")});
        shaders["filter.comp"] = compute({sampled("src"), image_out("dst")});
    }

    // Returns a graph in which pass "f" reads the cleared image "x" and writes "y". "f" is the pass under
    // test.
    std::string filter_pass(const std::string& shader, const std::string& more = "",
                            const std::string& format = "rgba16f") {
        return R"j("consts": {"taps": 9}, "params": {"gain": {"default": 2}}, "resources": {"x": ")j" +
               format +
               R"j(", "y": "rgba16f"}, "passes": {"c": {"type": "clear", "out": ["x"]},
"f": {"type": "compute", "shader": ")j" +
               shader + R"j(", "in": {"src": "x"}, "out": {"dst": "y"})j" + more + "}}";
    }
};

TEST_F(ResolveInterface, PortWithoutBinding) {
    shaders["other.comp"] = compute({sampled("picture"), image_out("dst")});
    const Result<ResolvedGraph> r = run(filter_pass("other.comp"));
    ASSERT_FALSE(r.ok());
    // There are two errors: port "src" has no binding in the shader, and the shader's binding "picture" has
    // no port.
    ASSERT_EQ(r.errors().size(), 2u) << to_text(r.errors());
    EXPECT_EQ(r.errors()[0].code, "W170");
    EXPECT_EQ(r.errors()[0].line, 2u);
    expect_help(r.errors()[0], R"j("dst", "picture")j");
    EXPECT_EQ(r.errors()[1].code, "W171");
    EXPECT_NE(r.errors()[1].message.find(R"j(binds "picture")j"), std::string::npos);
}

TEST_F(ResolveInterface, AMisspeltPortIsReportedOnce) {
    shaders["other.comp"] = compute({sampled("scr"), image_out("dst")});
    const Diagnostic d = bad(filter_pass("other.comp"));
    EXPECT_EQ(d.code, "W170");
    expect_help(d, "did you mean \"scr\"");
}

TEST_F(ResolveInterface, OptionalBinding) {
    ShaderProgram p = compute({sampled("src"), sampled("bloom"), image_out("dst")});
    SpecConstant has;
    has.name = "HAS_bloom";
    has.id = 3;
    p.interface.spec_constants = {has};
    shaders["f.comp"] = p;
    const ResolvedGraph g = good(filter_pass("f.comp"));
    ASSERT_EQ(pass_in(g, "f").spec_values.size(), 1u);
    EXPECT_EQ(pass_in(g, "f").spec_values[0].id, 3u);
    EXPECT_EQ(pass_in(g, "f").spec_values[0].bits, 0u);
}

TEST_F(ResolveInterface, FailedShaderIsNotReportedAgain) {
    shaders["broken.comp"] = {};
    const Result<ResolvedGraph> r =
        run(R"j("resources": {"x": "rgba16f", "y": "rgba16f", "z": "nope|rgba16f"}, "passes": {
      "a": {"type": "compute", "shader": "broken.comp", "out": {"dst": "x"}},
      "b": {"type": "compute", "shader": "filter.comp", "in": {"src": "x"}, "out": {"dst": "y"}}})j");
    ASSERT_FALSE(r.ok());
    EXPECT_EQ(r.errors().size(), 1u) << to_text(r.errors());
    EXPECT_EQ(r.errors()[0].code, "W116");
}

TEST_F(ResolveInterface, FloatSamplerOnIntegers) {
    const Diagnostic d = bad(filter_pass("filter.comp", "", "r32u"));
    EXPECT_EQ(d.code, "W172");
    EXPECT_NE(d.message.find(R"j("r32u")j"), std::string::npos) << d.message;
}

TEST_F(ResolveInterface, StorageFormatMustBeTheResources) {
    shaders["wrong.comp"] = compute({sampled("src"), image_out("dst", Format::rgba8)});
    const Diagnostic d = bad(filter_pass("wrong.comp"));
    EXPECT_EQ(d.code, "W172");
    EXPECT_NE(d.message.find("layout(rgba8)"), std::string::npos) << d.message;
}

TEST_F(ResolveInterface, FallbackFormatsCantBeReadAsStorage) {
    shaders["rw.comp"] = compute({image_in_out("x")});
    const Diagnostic d = bad(R"j("resources": {"x": "rgba16f|rgba32f"}, "passes": {
      "a": {"type": "compute", "shader": "rw.comp", "out": ["x"]}})j");
    EXPECT_EQ(d.code, "W172");
    expect_help(d, "rgba16f");
}

TEST_F(ResolveInterface, DirectionsMustAgree) {
    shaders["readonly.comp"] = compute({sampled("src"), image_in("dst")});
    EXPECT_EQ(bad(filter_pass("readonly.comp")).code, "W112");
    EXPECT_NE(bad(filter_pass("readonly.comp")).message.find("only reads"), std::string::npos);
    shaders["writes.comp"] = compute({image_in_out("src"), image_out("dst")});
    const Diagnostic d = bad(filter_pass("writes.comp"));
    EXPECT_NE(d.message.find("may write"), std::string::npos);
    expect_help(d, "readonly");
}

TEST_F(ResolveInterface, BufferForAnImage) {
    shaders["buf.comp"] = compute({buffer("src", true, false), image_out("dst")});
    EXPECT_EQ(bad(filter_pass("buf.comp")).code, "W173");
}

TEST_F(ResolveInterface, DimensionsMustAgree) {
    shaders["cube.comp"] = compute({sampled("src"), image_out("dst")});
    shaders["cube.comp"].interface.bindings[0].dim = ImageDim::cube;
    const Diagnostic d = bad(filter_pass("cube.comp"));
    EXPECT_EQ(d.code, "W173");
    EXPECT_NE(d.message.find("Cube"), std::string::npos);
}

TEST_F(ResolveInterface, StorageImageIsOneMip) {
    const Diagnostic d = bad(R"j("resources": {"x": {"format": "rgba16f", "mips": 3}}, "passes": {
      "a": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}}})j");
    EXPECT_EQ(d.code, "W173");
    expect_help(d, "x.mip(0)");
}

TEST_F(ResolveInterface, OneSubresourceHasOneLayout) {
    const Diagnostic d = bad(R"j("resources": {"x": "rgba16f"}, "passes": {
      "c": {"type": "clear", "out": ["x"]},
      "a": {"type": "compute", "shader": "filter.comp", "in": {"src": "x"}, "out": {"dst": "x"}}})j");
    EXPECT_EQ(d.code, "W163");
    EXPECT_NE(d.message.find("different layouts"), std::string::npos) << d.message;
}

TEST_F(ResolveInterface, SmallBuffer) {
    shaders["b.comp"] = compute({buffer("dst", false, true)});
    shaders["b.comp"].interface.bindings[0].block_bytes = 64;
    const Diagnostic d = bad(R"j("resources": {"x": {"buffer": "u32", "count": 4}}, "passes": {
      "a": {"type": "compute", "shader": "b.comp", "out": {"dst": "x"}, "groups": 1}})j");
    EXPECT_EQ(d.code, "W166");
    EXPECT_NE(d.message.find("64 bytes"), std::string::npos);
}

TEST_F(ResolveInterface, ParamsByName) {
    shaders["p.comp"] = with_params(
        compute({sampled("src"), image_out("dst")}),
        {member("strength"), member("gain"), member("taps"), member("dstSize", 2, ScalarType::u32),
         member("frameIndex", 1, ScalarType::u32), member("tint", 3)});
    const ResolvedGraph g =
        good(filter_pass("p.comp", R"j(, "params": {"strength": "gain * 2", "tint": [1, 0.5, 0.25]})j"));
    const PassDecl& f = pass_in(g, "f");
    ASSERT_EQ(f.params.size(), 6u);
    EXPECT_EQ(f.params[0].value[0], 4.0);
    EXPECT_EQ(f.params[1].value[0], 2.0);
    EXPECT_EQ(f.params[2].value[0], 9.0);
    EXPECT_EQ(f.params[3].value[0], 640.0);
    EXPECT_EQ(f.params[3].value[1], 360.0);
    EXPECT_EQ(f.params[4].builtin, Builtin::frame_index);
    EXPECT_EQ(f.params[5].value[1], 0.5);
    EXPECT_TRUE(f.params_push);
    EXPECT_EQ(f.params_bytes, 4u * 9);
}

TEST_F(ResolveInterface, ParamsWithoutValueOrMember) {
    shaders["p.comp"] = with_params(compute({sampled("src"), image_out("dst")}), {member("strenght")});
    const Result<ResolvedGraph> r = run(filter_pass("p.comp", R"j(, "params": {"strength": 1})j"));
    ASSERT_FALSE(r.ok());
    ASSERT_EQ(r.errors().size(), 2u) << to_text(r.errors());
    EXPECT_EQ(r.errors()[0].code, "W113");
    expect_help(r.errors()[0], "did you mean \"strenght\"");
    EXPECT_EQ(r.errors()[1].code, "W113");
    shaders["p.comp"] = with_params(compute({sampled("src"), image_out("dst")}), {member("gian")});
    expect_help(bad(filter_pass("p.comp")), "did you mean \"gain\"");
}

TEST_F(ResolveInterface, ParamsComponentsMustAgree) {
    shaders["p.comp"] = with_params(compute({sampled("src"), image_out("dst")}), {member("v", 3)});
    EXPECT_EQ(bad(filter_pass("p.comp", R"j(, "params": {"v": [1, 2]})j")).code, "W113");
}

TEST_F(ResolveInterface, PushConstantsHaveALimit) {
    profile.max_push_constants_bytes = 4;
    shaders["p.comp"] =
        with_params(compute({sampled("src"), image_out("dst")}), {member("gain"), member("taps")});
    EXPECT_EQ(bad(filter_pass("p.comp")).code, "W178");
}

TEST_F(ResolveInterface, DispatchFromTheOutput) {
    output_extent = {641, 361, 1};
    const ResolvedGraph g = good(R"j("resources": {"x": {"format": "rgba16f", "mips": 3}}, "passes": {
      "a": {"type": "compute", "shader": "make.comp", "out": {"dst": "x.mip(1)"}},
      "b": {"type": "compute", "shader": "make.comp", "out": {"dst": "x.mip(0)"}, "threads": "output / 2"},
      "c": {"type": "compute", "shader": "make.comp", "out": {"dst": "x.mip(2)"}, "groups": [3, 2, 1]}})j");
    EXPECT_EQ(pass_in(g, "a").groups, (std::array<uint32_t, 3>{40, 23, 1}));
    EXPECT_EQ(pass_in(g, "b").groups, (std::array<uint32_t, 3>{41, 23, 1}));
    EXPECT_EQ(pass_in(g, "c").groups, (std::array<uint32_t, 3>{3, 2, 1}));
}

TEST_F(ResolveInterface, DispatchUnknown) {
    shaders["b.comp"] = compute({buffer("dst", false, true)});
    const Diagnostic buffers = bad(R"j("resources": {"x": {"buffer": "u32", "count": 4}}, "passes": {
      "a": {"type": "compute", "shader": "b.comp", "out": {"dst": "x"}}})j");
    EXPECT_EQ(buffers.code, "W114");
    expect_help(buffers, "groups");
    shaders["two.comp"] = compute({image_out("a"), image_out("b")});
    const Diagnostic differ = bad(R"j("resources": {"x": {"format": "rgba16f", "mips": 2}}, "passes": {
      "a": {"type": "compute", "shader": "two.comp", "out": {"a": "x.mip(0)", "b": "x.mip(1)"}}})j");
    EXPECT_EQ(differ.code, "W114");
    EXPECT_NE(differ.message.find("320x180"), std::string::npos) << differ.message;
}

TEST_F(ResolveInterface, UnknownPassType) {
    const Diagnostic d =
        bad(R"j("resources": {"x": "rgba16f"}, "passes": {"a": {"type": "cleer", "out": ["x"]}})j");
    EXPECT_EQ(d.code, "W115");
    expect_help(d, "did you mean \"clear\"");
}

TEST_F(ResolveInterface, CopyEndsMustMatch) {
    const auto body = [](const std::string& format) {
        return R"j("resources": {"x": "rgba16f", "y": ")j" + format + R"j("}, "passes": {
          "c": {"type": "clear", "out": ["x"]},
          "k": {"type": "copy", "in": {"src": "x"}, "out": {"dst": "y"}}})j";
    };
    const ResolvedGraph g = good(body("rgba16"));
    EXPECT_EQ(use(g, "k", "dst").access, Access::copy_write);
    EXPECT_EQ(use(g, "c", "x").access, Access::clear_write);
    EXPECT_EQ(bad(body("rgba8")).code, "W183");
}

Status refuse(const PassDecl& pass, const ResolvedGraph&) {
    Diagnostic d;
    d.code = "P001";
    d.message = pass.name + " is too small";
    return d;
}

TEST_F(ResolveInterface, CppPasses) {
    PassType type;
    type.name = "upload";
    type.ports = {Out{"lights", Access::copy_write}};
    type.params = {ParamDecl{"limit", 8, 1, 16, ""}};
    passes["upload"] = type;
    const auto body = [](const std::string& more) {
        return R"j(
"resources": {"lights": {"buffer": "Light", "count": 4}},
"passes": {"u": {"type": "upload", "out": ["lights"])j" +
               more + "}}";
    };
    const ResolvedGraph g = good(body(R"j(, "params": {"limit": 4})j"));
    EXPECT_EQ(pass_in(g, "u").kind, PassKind::custom);
    EXPECT_EQ(use(g, "u", "lights").access, Access::copy_write);
    EXPECT_EQ(use(g, "u", "lights").state.stages, stage::kCopy);
    ASSERT_EQ(pass_in(g, "u").custom_params.size(), 1u);
    EXPECT_EQ(pass_in(g, "u").custom_params[0].value, 4.0);
    EXPECT_EQ(good(body("")).passes[0].custom_params[0].value, 8.0);
    EXPECT_EQ(bad(body(R"j(, "params": {"limit": 99})j")).code, "W113");
    EXPECT_EQ(bad(body(R"j(, "params": {"limt": 9})j")).code, "W113");
    passes["upload"].check = &refuse;
    const Diagnostic d = bad(body(""));
    EXPECT_EQ(d.code, "P001");
    EXPECT_EQ(d.line, 3u);
}

TEST_F(ResolveInterface, CppPassesNameTheShaderStagesOfTheirPorts) {
    PassType type;
    type.name = "overlay";
    type.ports = {In{"x", Access::sampled_read, stage_bit(ShaderStage::fragment)},
                  In{"z", Access::sampled_read}, Out{"target", Access::color_read_write}};
    passes["overlay"] = type;
    const ResolvedGraph g =
        good(R"j("resources": {"x": "rgba16f", "y": "rgba16f", "z": "rgba16f"}, "passes": {
      "c": {"type": "clear", "out": ["x", "y", "z"]},
      "o": {"type": "overlay", "in": ["x", "z"], "out": {"target": "y"}, "after": ["c"]}})j");
    EXPECT_EQ(use(g, "o", "x").state.stages, stage::kFragmentShader);
    EXPECT_EQ(use(g, "o", "z").state.stages, stage::kComputeShader) << "the stage of a port that names none";
    EXPECT_EQ(use(g, "o", "target").access, Access::color_read_write);
    EXPECT_EQ(use(g, "o", "target").state.layout, Layout::color_attachment);
    EXPECT_EQ(use(g, "o", "target").sources.size(), 1u) << "it continues what the clear pass has written";
}

TEST_F(ResolveInterface, CppPassPorts) {
    PassType type;
    type.name = "upload";
    type.ports = {Out{"lights", Access::copy_write}};
    passes["upload"] = type;
    const Result<ResolvedGraph> r = run(R"j("resources": {"x": {"buffer": "Light", "count": 4}},
      "passes": {"u": {"type": "upload", "out": {"light": "x"}}})j");
    ASSERT_FALSE(r.ok());
    ASSERT_EQ(r.errors().size(), 1u) << to_text(r.errors());
    EXPECT_EQ(r.errors()[0].code, "W176");
    expect_help(r.errors()[0], "did you mean \"lights\"");
    const Diagnostic none = bad(R"j("resources": {"x": {"buffer": "Light", "count": 4}},
      "passes": {"u": {"type": "upload"}, "c": {"type": "clear", "out": ["x"]}})j");
    EXPECT_EQ(none.code, "W176");
    EXPECT_NE(none.message.find("has no port"), std::string::npos) << none.message;
}

}  // namespace
}  // namespace weft::test

// Tests requirements of shaders that do not concern ports: descriptor sets, point sizes and local sizes. Also
// tests viewports, the attachments that fullscreen passes must clear, and the conversion of numbers to other
// types.
#include "graph/diagnostics/whole_number.h"
#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

ShaderBinding at(uint32_t set, uint32_t binding, BindingKind kind) {
    ShaderBinding b;
    b.name = "there";
    b.set = set;
    b.binding = binding;
    b.kind = kind;
    return b;
}

// Returns the program with one more binding, which all stages of the program use.
ShaderProgram with_binding(ShaderProgram p, const ShaderBinding& binding) {
    p.interface.bindings.push_back(binding);
    p.interface.bindings.back().stages = p.interface.stages;
    return p;
}

class ResolveShaderFit : public ResolveTest {
 protected:
    ResolveShaderFit() {
        constexpr ShaderStageMask all = 7;
        imports.bindings = {{0, 0, BindingKind::uniform_buffer, all, 64, false},
                            {0, 2, BindingKind::sampled_image, all, 0, false},
                            {2, 0, BindingKind::uniform_buffer, all, 64, false},
                            {3, 0, BindingKind::storage_buffer, stage_bit(ShaderStage::vertex), 0, false}};
    }

    static std::string pass(const std::string& type, const std::string& more = "") {
        const bool computes = type == "compute";
        return R"j("resources": {"x": "rgba16f"}, "passes": {"p": {"type": ")j" + type +
               R"j(", "shader": "s", "out": {")j" + (computes ? "dst" : "color") + R"j(": "x"})j" + more +
               "}}";
    }
    static std::string lists(const std::string& more = "") {
        return R"j("imports": {"opaque": "drawlist"}, )j" +
               pass("raster", R"j(, "draws": ["opaque"])j" + more);
    }
};

TEST_F(ResolveShaderFit, SetsOfDrawsAreForRasterPassesThatDrawLists) {
    for (const uint32_t set : {2u, 3u}) {
        const BindingKind kind = set == 2 ? BindingKind::uniform_buffer : BindingKind::storage_buffer;
        shaders["s"] = with_binding(compute({image_out("dst")}), at(set, 0, kind));
        const Diagnostic d = bad(pass("compute"));
        EXPECT_EQ(d.code, "W185");
        expect_help(d, "remove set and binding from the layout");
        shaders["s"] = with_binding(fragment({"color"}), at(set, 0, kind));
        EXPECT_EQ(bad(pass("fullscreen")).code, "W185");
        EXPECT_EQ(bad(pass("raster", R"j(, "draws": {"vertices": 3})j")).code, "W167");
    }
    shaders["s"] = with_binding(fragment({"color"}), at(2, 0, BindingKind::uniform_buffer));
    good(lists());
}

TEST_F(ResolveShaderFit, EachBindingMustBeThere) {
    const auto code_of = [&](ShaderBinding binding) {
        shaders["s"] = with_binding(compute({image_out("dst")}), binding);
        return bad(pass("compute")).code;
    };
    EXPECT_EQ(code_of(at(0, 7, BindingKind::uniform_buffer)), "W185");
    EXPECT_EQ(code_of(at(0, 0, BindingKind::storage_buffer)), "W185");
    ShaderBinding large = at(0, 0, BindingKind::uniform_buffer);
    large.block_bytes = 65;
    EXPECT_EQ(code_of(large), "W185");
    ShaderBinding cube = at(0, 2, BindingKind::sampled_image);
    cube.dim = ImageDim::cube;
    EXPECT_EQ(code_of(cube), "W185");
    // Only the vertex stage may read the buffer of instances (set 3, binding 0), and no stage may write it.
    shaders["s"] = with_binding(fragment({"color"}), at(3, 0, BindingKind::storage_buffer));
    EXPECT_EQ(bad(lists()).code, "W185");
    ShaderBinding instances = at(3, 0, BindingKind::storage_buffer);
    shaders["s"] = fragment({"color"});
    instances.stages = stage_bit(ShaderStage::vertex);
    instances.writes = true;
    shaders["s"].interface.bindings = {instances};
    EXPECT_EQ(bad(lists()).code, "W185");
    shaders["s"].interface.bindings.front().writes = false;
    good(lists());
}

TEST_F(ResolveShaderFit, TheSourceOfAListBindsTheSetsOfTheShader) {
    shaders["s"] = with_binding(fragment({"color"}), at(2, 0, BindingKind::uniform_buffer));
    imports.imports["opaque"].draw_sets = 1u << 2;
    good(lists());
    imports.imports["opaque"].draw_sets = 1u << 3;
    const Diagnostic d = bad(lists());
    EXPECT_EQ(d.code, "W256");
    expect_help(d, "SessionInput::draw_sets");
}

TEST_F(ResolveShaderFit, AFaultListsWhatTheProgramBinds) {
    shaders["s"] = with_binding(fragment({"color"}), at(3, 1, BindingKind::storage_buffer));
    expect_help(bad(lists()), "the program binds in set 3: 0: storage buffer in vertex shaders");
    std::erase_if(imports.bindings, [](const OfferedBinding& offered) { return offered.set == 3; });
    expect_help(bad(lists()), "the program binds in set 3: nothing");
}

TEST_F(ResolveShaderFit, PointsHaveASize) {
    shaders["s"] = fragment({"color"});
    for (const char* state : {R"j("topology": "points")j", R"j("fill": "point")j"}) {
        const std::string points = std::string(", \"state\": {") + state + "}";
        const Diagnostic d = bad(lists(points));
        EXPECT_EQ(d.code, "W186");
        expect_help(d, "gl_PointSize");
        EXPECT_EQ(bad(pass("fullscreen", points)).code, "W186");
    }
    shaders["s"].interface.writes_point_size = true;
    good(lists(R"j(, "state": {"topology": "points"})j"));
}

TEST_F(ResolveShaderFit, AShaderWithoutALocalSizeWarns) {
    shaders["s"] = compute({image_out("dst")});
    good(pass("compute", R"j(, "groups": 1)j"));
    for (const Diagnostic& d : warnings) EXPECT_NE(d.code, "W137");
    warnings.clear();
    shaders["s"].interface.states_local_size = false;
    good(pass("compute", R"j(, "groups": 1)j"));
    ASSERT_FALSE(warnings.empty());
    const auto warned = std::ranges::find(warnings, std::string("W137"), &Diagnostic::code);
    ASSERT_NE(warned, warnings.end());
    EXPECT_GT(warned->line, 0u);
}

TEST_F(ResolveShaderFit, ParametersFitTheirMembers) {
    const auto value = [&](ScalarType type, const char* number) {
        shaders["s"] = with_params(compute({image_out("dst")}), {member("n", 1, type)});
        return run(pass("compute", std::string(R"j(, "params": {"n": )j") + number + "}"));
    };
    for (const char* far : {"1e308", "-1e308", "5e9", "-3e9"})
        for (const ScalarType type : {ScalarType::i32, ScalarType::u32}) {
            const Result<ResolvedGraph> found = value(type, far);
            ASSERT_FALSE(found.ok()) << far;
            EXPECT_EQ(found.errors().front().code, "W113");
        }
    EXPECT_FALSE(value(ScalarType::f32, "1e39").ok());
    EXPECT_TRUE(value(ScalarType::u32, "-1").ok());
    EXPECT_TRUE(value(ScalarType::u32, "4294967295").ok());
    EXPECT_TRUE(value(ScalarType::f32, "1e38").ok());
}

TEST_F(ResolveShaderFit, ViewportsLieWhereTheDeviceHasSome) {
    shaders["s"] = fragment({"color"});
    profile.max_image_2d_px = 4096;
    const auto viewport = [&](const std::string& rect) {
        return run(pass("fullscreen", R"j(, "state": {"viewport": )j" + rect + "}")).ok();
    };
    EXPECT_TRUE(viewport("[-8192, 0, 4096, 4096]"));
    EXPECT_FALSE(viewport("[0, 0, 4097, 1]"));
    EXPECT_FALSE(viewport("[-8193, 0, 1, 1]"));
    EXPECT_FALSE(viewport("[0, 4096, 1, 4096]"));
}

// With some pipeline states, for example a scissor, a fullscreen pass leaves texels undrawn. Then the
// attachment must be cleared. Otherwise these texels would show data of the resource that used the memory
// before.
TEST_F(ResolveShaderFit, AFullscreenPassThatMayLeaveTexelsOutIsCleared) {
    shaders["s"] = fragment({"color"});
    shaders["s"].interface.writes_point_size = true;
    const auto covers = [&](const std::string& state) {
        const ResolvedGraph graph = good(pass("fullscreen", ", \"state\": {" + state + "}"));
        return !graph.passes.empty() && graph.passes.front().colors.front().covers;
    };
    EXPECT_TRUE(covers(""));
    for (const char* state : {R"j("cull": "back")j", R"j("cull": "front")j", R"j("fill": "line")j",
                              R"j("fill": "point")j", R"j("topology": "lines")j", R"j("topology": "points")j",
                              R"j("scissor": [0, 0, 8, 8])j", R"j("viewport": [0, 0, 8, 8])j"})
        EXPECT_FALSE(covers(state)) << state;
}

TEST(WholeNumber, FitsOrIsNothing) {
    EXPECT_EQ(whole_number<uint32_t>(4294967295.0), 4294967295u);
    EXPECT_FALSE(whole_number<uint32_t>(4294967296.0));
    EXPECT_FALSE(whole_number<uint32_t>(-1));
    EXPECT_FALSE(whole_number<uint32_t>(0.5));
    EXPECT_EQ(whole_number<int32_t>(-2147483648.0), INT32_MIN);
    EXPECT_FALSE(whole_number<int32_t>(2147483648.0));
    for (const double far : {1e308, HUGE_VAL, std::nan("")}) {
        EXPECT_FALSE(whole_number<int64_t>(far));
        EXPECT_FALSE(whole_number<uint64_t>(far));
    }
    EXPECT_EQ(saturated<int64_t>(1e308), INT64_MAX);
    EXPECT_EQ(saturated<int64_t>(-1e308), INT64_MIN);
    EXPECT_EQ(saturated<int64_t>(-9223372036854775808.0), INT64_MIN);
    EXPECT_EQ(saturated<uint32_t>(-2), 0u);
    EXPECT_EQ(saturated<uint32_t>(std::nan("")), 0u);
    EXPECT_EQ(saturated_float(1e308), std::numeric_limits<float>::max());
    EXPECT_EQ(saturated_float(-1e308), -std::numeric_limits<float>::max());
}

}  // namespace
}  // namespace weft::test

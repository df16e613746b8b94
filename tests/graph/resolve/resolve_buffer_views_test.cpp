// Tests lists of views whose matrices are the elements of a buffer of the graph.
#include <algorithm>

#include "tests/graph/resolve/resolve_fixture.h"
#include "tests/graph/samples/random_graph.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"
#include "weft/report/plan_explain.h"

namespace weft::test {
namespace {

constexpr uint32_t kViewBytes = 512;

// Returns a shader whose vertex stage reads the view.
ShaderProgram reads_view(ShaderProgram shader) {
    ShaderBinding view = sampled("ViewBlock");
    view.set = 0;
    view.binding = kViewBinding;
    view.kind = BindingKind::uniform_buffer;
    view.stages = stage_bit(ShaderStage::vertex);
    view.block_bytes = kViewBytes;
    shader.interface.bindings.insert(shader.interface.bindings.begin(), view);
    shader.interface.frame_ranges.push_back({kViewBinding, 0, 64});
    return shader;
}

class ResolveBufferViews : public ResolveTest {
 protected:
    ResolveBufferViews() {
        shaders["fit"] = compute({buffer("matrices", false, true)});
        shaders["mesh"] = reads_view(fragment({"color"}));
        shaders["flat"] = fragment({"color"});
        imports.strides["ViewConstants"] = kViewBytes;
    }
    // A graph that writes four views to a buffer, and draws with the keys `pass`.
    static std::string graph(const std::string& pass, const std::string& list = kList,
                             const std::string& buffer = kBuffer) {
        const std::string color = pass.starts_with("\"views\"") ? "\"color\"" : "\"color.layer(0)\"";
        return R"j("imports": {"opaque": "drawlist"}, "views": {)j" + list +
               R"j(}, "resources": {"color": {"format": "rgba8", "size": 16, "layers": 4}, "matrices": )j" +
               buffer +
               R"j(}, "passes": {"fit": {"type": "compute", "shader": "fit", "out": ["matrices"], "threads": 4},
            "a": {"type": "raster", "draws": ["opaque"], "shader": "mesh", "out": [)j" +
               color + "], " + pass + R"j(}, "end": {"type": "readback", "in": [)j" + color + "]}}";
    }
    static constexpr const char* kList = R"j("fitted": {"buffer": "matrices", "count": 4})j";
    static constexpr const char* kBuffer = R"j({"buffer": "ViewConstants", "count": 4})j";
};

TEST_F(ResolveBufferViews, AreInputsOfThePassesThatReadThem) {
    const ResolvedGraph g = good(graph(R"j("view": "fitted(2)")j"));
    const PassDecl& pass = pass_in(g, "a");
    EXPECT_EQ(pass.view, "fitted(2)");
    ASSERT_LT(pass.view_use, pass.uses.size());
    const UseDecl& view = pass.uses[pass.view_use];
    EXPECT_EQ(view.port, "views:fitted");
    EXPECT_EQ(g.resources[view.resource].name, "matrices");
    EXPECT_EQ(view.bytes, (ByteRange{2 * kViewBytes, kViewBytes}));
    EXPECT_EQ(view.access, Access::uniform_read);
    EXPECT_EQ(view.state.stages, stage::kVertexShader);
    EXPECT_EQ(view.state.access, access::kUniformRead);
    EXPECT_EQ(view.binding, kNoId);
    EXPECT_EQ(seen(g, "a", "views:fitted"), "fit");
    EXPECT_TRUE(has_edge(g, "fit", "a", EdgeKind::raw));
    EXPECT_FALSE(pass.culls_draws) << "the CPU does not know the frustum";
    ASSERT_EQ(g.views.size(), 1u);
    EXPECT_EQ(g.views[0].source, ViewSource::buffer);
    EXPECT_EQ(g.views[0].of, "matrices");
}

TEST_F(ResolveBufferViews, AreAllDrawnByOnePass) {
    const ResolvedGraph g = good(graph(R"j("views": "fitted")j"));
    for (uint32_t i = 0; i < 4; ++i) {
        const PassDecl& pass = pass_in(g, ("a#" + std::to_string(i)).c_str());
        EXPECT_EQ(pass.uses.at(pass.view_use).bytes, (ByteRange{i * kViewBytes, kViewBytes}));
        EXPECT_EQ(pass.uses.at(pass.view_use).range.layer, i) << "one piece of the buffer for each view";
    }
    const FramePlan plan = compile(g, content_needs(g), {});
    EXPECT_TRUE(check_plan(plan).empty());
    EXPECT_EQ(pass_in(good(graph(R"j("views": "fitted")j")), "fit").uses[0].range.layers, 4u);
}

TEST_F(ResolveBufferViews, AreNoInputsOfShadersThatDoNotReadTheView) {
    std::string text = graph(R"j("view": "fitted(2)")j");
    const ResolvedGraph g = good(text.replace(text.find("\"mesh\""), 6, "\"flat\""));
    EXPECT_EQ(pass_in(g, "a").view_use, kNoId);
    EXPECT_FALSE(has_edge(g, "fit", "a", EdgeKind::raw));
    EXPECT_EQ(pass_in(good(graph(R"j("view": "camera")j")), "a").view_use, kNoId);
}

TEST_F(ResolveBufferViews, CanBePartsOfLists) {
    const ResolvedGraph g =
        good(graph(R"j("view": "far(1)")j",
                   std::string(kList) + R"j(, "far": {"of": "fitted", "first": 2, "count": 2})j"));
    EXPECT_EQ(pass_in(g, "a").view, "fitted(3)");
    EXPECT_EQ(pass_in(g, "a").uses.at(pass_in(g, "a").view_use).bytes,
              (ByteRange{3 * kViewBytes, kViewBytes}));
    EXPECT_EQ(bad(graph(R"j("view": "fitted(4)")j")).code, "W109");
}

TEST_F(ResolveBufferViews, CanComeFromTheLastFrameOrFromAnEarlierVersion) {
    const ResolvedGraph past =
        good(graph(R"j("view": "old(1)")j", R"j("old": {"buffer": "matrices[-1]", "count": 2})j",
                   R"j({"buffer": "ViewConstants", "count": 4, "history": 1})j"));
    EXPECT_EQ(seen(past, "a", "views:old"), "before");
    EXPECT_EQ(past.views.at(0).of, "matrices[-1]");
    EXPECT_TRUE(check_plan(compile(past, content_needs(past), {})).empty());
    std::string text = graph(R"j("view": "first")j", R"j("first": {"buffer": "matrices@fit", "count": 1})j");
    const std::string readback = "\"end\":";
    text.replace(text.find(readback), readback.size(),
                 R"j("wipe": {"type": "clear", "out": ["matrices.range(0)"], "after": ["fit"]},
                     "keep": {"type": "readback", "in": ["matrices"]}, "end":)j");
    EXPECT_EQ(seen(good(text), "a", "views:first"), "fit");
}

TEST_F(ResolveBufferViews, CanBeAnImportOfTheProgram) {
    ResourceDecl& buffer = imports.imports["instances"].resource;
    buffer.stride_bytes = kViewBytes;
    buffer.size_bytes = 3 * kViewBytes;
    const std::string text =
        R"j("imports": {"opaque": "drawlist", "instances": "buffer"}, "views": {"mine": {"buffer": "instances", "count": 3}},
        "resources": {"color": {"format": "rgba8", "size": 16}}, "passes": {
        "a": {"type": "raster", "draws": ["opaque"], "shader": "mesh", "out": ["color"], "view": "mine(2)"},
        "end": {"type": "readback", "in": ["color"]}})j";
    EXPECT_EQ(seen(good(text), "a", "views:mine"), "before");
    buffer.stride_bytes = 64;
    EXPECT_EQ(bad(text).code, "W230");
}

TEST_F(ResolveBufferViews, NeedABufferOfViews) {
    const std::string pass = R"j("view": "fitted(2)")j";
    const Diagnostic floats = bad(graph(pass, kList, R"j({"buffer": "vec4", "count": 400})j"));
    EXPECT_EQ(floats.code, "W230");
    expect_help(floats, "\"buffer\": \"ViewConstants\"");
    const Diagnostic image = bad(graph(pass, R"j("fitted": {"buffer": "color", "count": 4})j"));
    EXPECT_EQ(image.code, "W230");
    const Diagnostic few = bad(graph(pass, kList, R"j({"buffer": "ViewConstants", "count": 2})j"));
    EXPECT_EQ(few.code, "W230");
    EXPECT_NE(few.message.find("has only 2 elements"), std::string::npos) << few.message;
    // One error for all passes of a list, not one for each view.
    EXPECT_EQ(bad(graph(R"j("views": "fitted")j", kList, R"j({"buffer": "vec4", "count": 400})j")).code,
              "W230");
    EXPECT_EQ(bad(graph(pass, R"j("fitted": {"buffer": "matrixes", "count": 4})j")).code, "W103");
    EXPECT_EQ(bad(graph(pass, R"j("fitted": {"buffer": "matrices.range(0..3)", "count": 4})j")).code, "W230");
}

TEST_F(ResolveBufferViews, NeedAPassThatWritesThem) {
    std::string text = graph(R"j("view": "fitted(2)")j");
    const std::string keys = "\"threads\": 4";
    const Diagnostic d = bad(text.replace(text.find(keys), keys.size(), keys + ", \"if\": 0"));
    EXPECT_EQ(d.code, "W123");
    expect_help(d, "remove the passes that draw these views");
    for (const std::string& help : d.help) EXPECT_EQ(help.find("else"), std::string::npos) << help;
}

TEST_F(ResolveBufferViews, HaveTheirOwnKeys) {
    const std::string pass = R"j("view": "fitted(2)")j";
    EXPECT_EQ(bad(graph(pass, R"j("fitted": {"buffer": "matrices"})j")).code, "W108");
    for (const char* other : {R"j("of": "camera")j", R"j("plane": [0, 1, 0, 0])j", R"j("first": 1)j",
                              R"j("cube": {"at": [0, 0, 0]})j"})
        EXPECT_EQ(
            run(graph(pass, std::string(R"j("fitted": {"buffer": "matrices", "count": 4, )j") + other + "}"))
                .errors()
                .at(0)
                .code,
            "W109")
            << other;
}

TEST_F(ResolveBufferViews, HaveNoMirrors) {
    const std::string mirror =
        R"j(, "mirror": {"of": "part", "plane": [0, 1, 0, 0]}, "part": {"of": "fitted"},
        "again": {"of": "mirror", "plane": [1, 0, 0, 0]}, "first": {"of": "mirror", "count": 1})j";
    const Diagnostic d = bad(graph(R"j("views": "again")j", kList + mirror));
    EXPECT_EQ(d.code, "W230");
    EXPECT_NE(d.message.find("\"mirror\" is a mirror of \"fitted\""), std::string::npos) << d.message;
    expect_help(d, "write the mirrored matrices");
}

TEST_F(ResolveBufferViews, AreTheReasonWhyAPassWaits) {
    const ResolvedGraph g = good(graph(R"j("view": "fitted(2)")j"));
    const FramePlan plan = compile(g, content_needs(g), {});
    const Result<std::string> why = explain_barrier(plan, "fit", "a");
    ASSERT_TRUE(why) << to_text(why.errors());
    EXPECT_NE(why->find("matrices.range(2)"), std::string::npos) << *why;
}

// Without one of its barriers, a pass could read a view before it is written, and overwrite a view that an
// earlier frame still reads.
TEST_F(ResolveBufferViews, NeedTheirBarriers) {
    const ResolvedGraph g = good(graph(R"j("views": "fitted")j"));
    const FramePlan plan = compile(g, content_needs(g), {});
    const ResourceId matrices = find_resource(g, "matrices");
    uint32_t removed = 0;
    for (size_t step = 0; step < plan.barriers.steps.size(); ++step)
        for (size_t i = 0; i < plan.barriers.steps[step].barriers.size(); ++i) {
            if (plan.barriers.steps[step].barriers[i].resource != matrices) continue;
            FramePlan wrong = plan;
            std::vector<BarrierDecl>& barriers = wrong.barriers.steps[step].barriers;
            barriers.erase(barriers.begin() + static_cast<std::ptrdiff_t>(i));
            EXPECT_FALSE(check_plan(wrong).empty()) << step << " " << i;
            ++removed;
        }
    EXPECT_GE(removed, 2u);
}

// A readable but wrong plan: another element, an access without the uniform read, culling on the CPU.
TEST_F(ResolveBufferViews, AreCheckedWithoutTheCompiler) {
    const ResolvedGraph g = good(graph(R"j("views": "fitted")j"));
    const FramePlan plan = compile(g, content_needs(g), {});
    const auto codes = [&](const auto& change) {
        FramePlan wrong = plan;
        change(wrong.graph.passes[find_pass(wrong.graph, "a#1")], wrong.graph);
        const Diagnostics found = check_plan(wrong);
        return std::ranges::any_of(found, [](const Diagnostic& d) { return d.code == "C347"; });
    };
    EXPECT_FALSE(codes([](PassDecl&, ResolvedGraph&) {}));
    EXPECT_TRUE(codes([](PassDecl& pass, ResolvedGraph&) {
        pass.uses[pass.view_use].bytes->offset_bytes = 2 * kViewBytes;
        pass.uses[pass.view_use].range.layer = 2;
    }));
    EXPECT_TRUE(codes([](PassDecl& pass, ResolvedGraph&) { pass.view = "fitted(0)"; }));
    EXPECT_TRUE(codes([](PassDecl& pass, ResolvedGraph&) { pass.view = "camera"; }));
    EXPECT_TRUE(codes([](PassDecl& pass, ResolvedGraph&) { pass.view_use = 77; }));
    EXPECT_TRUE(codes([](PassDecl& pass, ResolvedGraph&) { pass.culls_draws = true; }));
    EXPECT_TRUE(codes([](PassDecl&, ResolvedGraph& graph) { graph.views[0].of = "color"; }));
}

}  // namespace
}  // namespace weft::test

// Tests the numbers of a graph that follow live scales, and the errors about them.
#include "graph/live/live_frame.h"
#include "graph/resolve/change_values.h"
#include "tests/graph/resolve/live/live_fixture.h"
#include "weft/compile.h"
#include "weft/report/plan_dump.h"
#include "weft/report/plan_explain.h"

namespace weft::test {
namespace {

class LiveAreas : public LiveTest {
 protected:
    void evaluate(const std::string& text, const Scales& scales) {
        graph = good(text);
        evaluate_live(graph, scales, values);
    }
    Extent3D area(const char* image) const { return live_area(resource_in(graph, image), values); }
    // Returns a component of a member that Builtin::live fills; -1 for other members.
    double live_member(const char* pass, const char* name, size_t component = 0) const {
        for (const ParamWrite& write : pass_in(graph, pass).params)
            if (write.member == name && write.builtin == Builtin::live)
                return values[write.live.at(component)].x;
        return -1;
    }
    Builtin builtin(const char* pass, const char* name) const {
        for (const ParamWrite& write : pass_in(graph, pass).params)
            if (write.member == name) return write.builtin;
        return Builtin::none;
    }

    ResolvedGraph graph;
    std::vector<LiveNumber> values;
};

TEST_F(LiveAreas, ImagesAreAllocatedAtScaleOneAndUsedInTheirArea) {
    params["renderScale"] = 0.5;
    evaluate(body(), {});
    EXPECT_EQ(resource_in(graph, "color").extent, (Extent3D{640, 360, 1}));
    EXPECT_EQ(resource_in(graph, "low").extent, (Extent3D{320, 180, 1}));
    EXPECT_EQ(area("color"), (Extent3D{320, 180, 1}));
    EXPECT_EQ(area("low"), (Extent3D{160, 90, 1}));
    EXPECT_EQ(area("past[-2]"), (Extent3D{320, 180, 1}));
    EXPECT_EQ(area("backbuffer"), (Extent3D{640, 360, 1}));
    EXPECT_EQ(resource_in(graph, "low").area, resource_in(graph, "other").area) << "equal expressions";
}

TEST_F(LiveAreas, AnAreaIsRoundedUpAndNeverEmpty) {
    evaluate(body(), {{"renderScale", 0.7004}});
    EXPECT_EQ(area("color"), (Extent3D{449, 253, 1}));
    EXPECT_EQ(area("low"), (Extent3D{225, 127, 1}));
    output_extent = {30, 1, 1};
    evaluate(body(), {{"renderScale", 0.7}});
    EXPECT_EQ(area("color"), (Extent3D{21, 1, 1})) << "0.7 * 30 is above 21 only because of rounding";
    evaluate(body(), {{"renderScale", 0.01}});
    EXPECT_EQ(area("color"), (Extent3D{8, 1, 1})) << "a scale below its range";
    evaluate(body(), {{"renderScale", 100}});
    EXPECT_EQ(area("color"), (Extent3D{30, 1, 1})) << "a scale above its range";
}

TEST_F(LiveAreas, WorkgroupsFollowTheArea) {
    evaluate(body(), {{"renderScale", 0.5}});
    using Groups = std::array<uint32_t, 3>;
    EXPECT_EQ(pass_in(graph, "shrink").groups, (Groups{40, 23, 1}));
    EXPECT_EQ(live_groups(pass_in(graph, "shrink"), values), (Groups{20, 12, 1}));
    EXPECT_EQ(live_groups(pass_in(graph, "down#2"), values), (Groups{21, 12, 1})) << "162 and 90 threads";
}

TEST_F(LiveAreas, RectanglesFollowTheArea) {
    evaluate(body(R"j(, "state": {"viewport": ["-render.x / 4", 0, "render.x", 20],
                                    "scissor": [4, "render.y - 20", 20, 20]})j"),
             {{"renderScale", 0.5}});
    const RasterState state = live_state(pass_in(graph, "paint"), values);
    EXPECT_EQ(state.viewport, (RectPx{-80, 0, 320, 20}));
    EXPECT_EQ(state.scissor, (RectPx{4, 160, 20, 20}));
    EXPECT_EQ(pass_in(graph, "paint").state.scissor, (RectPx{4, 340, 20, 20})) << "at scale 1";
}

TEST_F(LiveAreas, MembersOfParamsFollowTheArea) {
    evaluate(body(), {{"renderScale", 0.5}});
    EXPECT_EQ(live_member("paint", "size", 0), 320);
    EXPECT_EQ(live_member("paint", "size", 1), 180);
    EXPECT_EQ(live_member("paint", "k"), 640) << "a constant that names a live size";
    EXPECT_EQ(live_member("paint", "renderScale"), 0.5) << "the scale itself";
    EXPECT_EQ(live_member("shrink", "steps"), 4);
    EXPECT_EQ(live_member("down#2", "steps"), -1) << "not live";
    EXPECT_EQ(builtin("shrink", "srcSize"), Builtin::area_size);
    EXPECT_EQ(builtin("shrink", "srcUv"), Builtin::area_uv);
    EXPECT_EQ(builtin("shrink", "srcUvMost"), Builtin::area_uv_most);
}

TEST_F(LiveAreas, AnImageWithoutALiveSizeIsUsedAsAWhole) {
    evaluate(
        R"j("resources": {"a": {"format": "rgba16f", "size": [8, 4]}, "b": {"format": "rgba16f", "size": 4}},
"passes": {"a": {"type": "compute", "shader": "make", "out": {"dst": "a"}},
  "b": {"type": "compute", "shader": "shrink", "in": {"src": "a"}, "out": {"dst": "b"},
        "params": {"steps": 1, "i": 1}}},
"tests": [{"size": [8, 8], "frames": 1, "expect": {"finite": ["b"]}}])j",
        {});
    const std::vector<ParamWrite>& block = pass_in(graph, "b").params;
    EXPECT_EQ(block[1].value, (std::array<double, 4>{1, 1, 0, 0}));
    EXPECT_EQ(block[2].value,
              (std::array<double, 4>{(8 - kFilterMargin_px) / 8, (4 - kFilterMargin_px) / 4, 0, 0}));
    EXPECT_TRUE(graph.live_values.empty());
}

TEST_F(LiveAreas, AScaleIsALiveValue) {
    graph = good(body());
    for (const GraphParam& param : graph.params) EXPECT_EQ(param.cost, ParamCost::live) << param.name;
}

TEST_F(LiveAreas, OtherPlacesSeeTheScaleOne) {
    params["renderScale"] = 0.25;
    evaluate(body("", R"j(, "list": {"buffer": "u32", "count": "renderScale * 16"},
                           "copies": {"format": "rgba8", "size": 4, "layers": "render.x / 64"})j"),
             {});
    EXPECT_EQ(resource_in(graph, "list").size_bytes, 64u);
    EXPECT_EQ(resource_in(graph, "copies").layers, 10u);
    EXPECT_EQ(resource_in(graph, "copies").area, uint32_t{kNoId});
}

TEST_F(LiveAreas, NewValuesGiveTheGraphFromScratch) {
    const Result<GraphDesc> desc = parsed(body());
    ASSERT_TRUE(desc);
    const auto input = [&](const GraphRequest& request) {
        return ResolveInput{.graph = *desc,
                            .passes = passes,
                            .shaders = shaders,
                            .imports = imports,
                            .profile = profile,
                            .request = request};
    };
    const GraphRequest before{.size = output_extent};
    GraphRequest after = before;
    after.params = {{"renderScale", 0.5}, {"gain", 3}};
    const Result<ResolvedGraph> known = resolve(input(before), warnings);
    ASSERT_TRUE(known);
    ASSERT_TRUE(only_values_differ(before, after, known->params));
    const std::optional<ResolvedGraph> changed = change_values(input(after), *known);
    const Result<ResolvedGraph> scratch = resolve(input(after), warnings);
    ASSERT_TRUE(changed && scratch);
    const auto plan_of = [](const ResolvedGraph& g) { return compile(g, content_needs(g), {}); };
    EXPECT_EQ(plan_hash(plan_of(*changed)), plan_hash(plan_of(*scratch)));
    EXPECT_EQ(structure_hash(plan_of(*known)), structure_hash(plan_of(*scratch)));
    EXPECT_NE(values_hash(*known), values_hash(*scratch));
}

TEST_F(LiveAreas, ThePlanTellsHowAreasFollow) {
    graph = good(body());
    const std::string text = plan_to_text(compile(graph, content_needs(graph), {}));
    EXPECT_NE(text.find("area   render = 640x360 × renderScale: color, past, past[-1], past[-2]\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("area   half = ceil(render / 2): low, other\n"), std::string::npos);
    const FramePlan plan = compile(graph, content_needs(graph), {});
    EXPECT_NE(plan_to_html(plan, {}).find("half = ceil(render / 2): low, other"), std::string::npos);
    const Result<std::string> explained = explain_resource(plan, "color");
    ASSERT_TRUE(explained);
    EXPECT_NE(explained->find("in a frame: render = 640x360 × renderScale.\n"), std::string::npos);
}

// The first error is about the parameter, the others about images and passes.
TEST_F(LiveAreas, FaultsOfLiveSizes) {
    const auto with = [](const std::string& param, const std::string& scale) {
        return R"j("params": {"s": )j" + param + R"j(}, "sizes": {"render": {"size": "output", "scale": ")j" +
               scale + R"j("}}, "resources": {"x": "rgba16f"},
"passes": {"a": {"type": "compute", "shader": "make", "out": {"dst": "x"}}},
"tests": [{"size": [8, 8], "frames": 1, "expect": {"finite": ["x"]}}])j";
    };
    EXPECT_EQ(bad(with("1", "t")).code, "W236");
    EXPECT_EQ(bad(with("1", "s")).code, "W236");
    EXPECT_EQ(bad(with(R"j({"default": 1, "range": [0.5, 2]})j", "s")).code, "W236");
    EXPECT_EQ(bad(with(R"j({"default": 1, "range": [0, 1]})j", "s")).code, "W236");
    EXPECT_EQ(good(with(R"j({"default": 0.5, "range": [0.1, 0.5]})j", "s")).output_extent, output_extent);
    expect_help(bad(with("1", "t")), "did you mean \"s\"");
}

TEST_F(LiveAreas, FaultsOfImagesAndPasses) {
    const auto resources = [&](const std::string& text) { return bad(body("", ", " + text)); };
    EXPECT_EQ(resources(R"j("y": {"format": "rgba8", "keep": "shared"})j").code, "W236");
    EXPECT_EQ(resources(R"j("y": {"format": "rgba8", "keep": true, "history": 1})j").code, "W236");
    EXPECT_EQ(
        resources(R"j("y": {"format": "rgba8", "kind": "cube", "size": "min(render.x, render.y)"})j").code,
        "W236");
    shaders["two"] = fragment({"color", "more"});
    const auto pass = [&](const std::string& resource, const std::string& text) {
        std::string graph_text = body("", ", " + resource);
        graph_text.insert(graph_text.rfind('}'), ", \"new\": " + text);
        return bad(graph_text);
    };
    const Diagnostic mixed = pass(
        R"j("y": {"format": "rgba8", "size": "output"})j",
        R"j({"type": "fullscreen", "shader": "two", "out": {"color": "color", "more": "y"}, "after": ["paint"]})j");
    EXPECT_EQ(mixed.code, "W236");
    EXPECT_NE(mixed.message.find("\"more\" is used as a whole"), std::string::npos) << mixed.message;
    EXPECT_EQ(pass(R"j("y": {"format": "rgba16f", "size": "output"})j",
                   R"j({"type": "copy", "in": {"src": "color"}, "out": {"dst": "y"}})j")
                  .code,
              "W236");
    const std::string kept = R"j("y": {"format": "rgba16f", "keep": true})j";
    const std::string make = R"j({"type": "compute", "shader": "make", "out": {"dst": "y"}})j";
    EXPECT_EQ(pass(kept, make).code, "W236");
    EXPECT_EQ(
        pass(R"j("y": "rgba16f")j", R"j({"type": "blit", "in": {"src": "other"}, "out": {"dst": "y"}})j")
            .code,
        "W236");
    // The extents of both are equal at scale 1, but not at all other scales.
    EXPECT_EQ(pass(R"j("y": {"format": "rgba16f", "size": "render / 2"})j",
                   R"j({"type": "copy", "in": {"src": "low.mip(0)"}, "out": {"dst": "y"}})j")
                  .code,
              "W236");
}

// Errors elsewhere in expressions with live sizes give no second message, and do not crash.
TEST_F(LiveAreas, OneMessageForACause) {
    const auto sizes = [&](const std::string& text) {
        return bad(
            R"j("params": {"s": {"default": 1, "range": [0.5, 1]}}, "sizes": {"render": {"size": "output",
"scale": "s"}, )j" +
            text + R"j(}, "resources": {"x": {"format": "rgba16f", "size": "part"}},
"passes": {"a": {"type": "compute", "shader": "make", "out": {"dst": "x"}, "threads": "part"}},
"tests": [{"size": [8, 8], "frames": 1, "expect": {"finite": ["x"]}}])j");
    };
    EXPECT_EQ(sizes(R"j("part": "rendr / 2")j").code, "W107");
    EXPECT_EQ(sizes(R"j("part": "render / 0")j").code, "W106");
    EXPECT_EQ(sizes(R"j("part": "render + part")j").code, "W106");
    EXPECT_EQ(sizes(R"j("part": {"size": "part", "scale": "s"})j").code, "W106");
}

TEST_F(LiveAreas, AnExpressionWithoutAValueInAFrameIsZero) {
    std::string text = body();
    const std::string usual = "gain * render.x";
    text.replace(text.find(usual), usual.size(), "1 / (render.x - 320)");
    evaluate(text, {{"renderScale", 0.5}});
    EXPECT_EQ(live_member("paint", "k"), 0);
}

}  // namespace
}  // namespace weft::test

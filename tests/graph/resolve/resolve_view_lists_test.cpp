// Tests lists of views: those of the program, those of the section "views", and passes that draw all views of a list.
#include <algorithm>

#include "tests/graph/resolve/resolve_fixture.h"
#include "tests/graph/samples/random_graph.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

class ResolveViewLists : public ResolveTest {
 protected:
    ResolveViewLists() {
        shaders["mesh"] = fragment({"color"});
        shaders["depthOnly"] = fragment({});
        imports.views = {"camera", "sun"};
        imports.imports["sun"] = {.name = "sun", .kind = ImportKind::views, .views = 4};
        imports.imports["lamps"] = {.name = "lamps", .kind = ImportKind::views, .views = 8};
        imports.imports["none"] = {.name = "none", .kind = ImportKind::views, .views = 0};
    }
    // A graph with the list "lamps" of 8 views, and one pass "a" that draws to the depth image `shadow`.
    static std::string graph(const std::string& pass, const std::string& more = "",
                             const std::string& shadow = R"j({"format": "d32f", "size": [64, 48]})j") {
        return R"j("imports": {"opaque": "drawlist", "lamps": "views"}, )j" + more +
               R"j("resources": {"shadow": )j" + shadow +
               R"j(}, "passes": {"a": {"type": "raster", "draws": ["opaque"], "shader": "depthOnly",
               "depth": "shadow", )j" +
               pass + "}}";
    }
    static std::string layers(const std::string& count) {
        return R"j({"format": "d32f", "size": 16, "layers": ")j" + count + "\"}";
    }
};

TEST_F(ResolveViewLists, OfTheProgramMustBeImported) {
    EXPECT_EQ(pass_in(good(graph(R"j("view": "lamps(5)")j")), "a").view, "lamps(5)");
    const std::string text = graph(R"j("view": "lamps(5)")j");
    const Diagnostic d = bad(std::string(text).replace(text.find(R"j(, "lamps": "views")j"), 18, ""));
    EXPECT_EQ(d.code, "W118");
    expect_help(d, "\"imports\": { \"lamps\": \"views\" }");
    EXPECT_EQ(bad(graph(R"j("view": "lamps(8)")j")).code, "W109");
    EXPECT_EQ(bad(graph(R"j("view": "lamp(1)")j")).code, "W118");
    EXPECT_EQ(bad(R"j("imports": {"spots": "views"}, "passes": {})j").code, "W118");
}

TEST_F(ResolveViewLists, HaveACountThatExpressionsName) {
    const ResolvedGraph g = good(graph(R"j("views": "lamps")j", "", layers("lampsViews + sunViews - 4")));
    EXPECT_EQ(resource_in(g, "shadow").layers, 8u);
}

TEST_F(ResolveViewLists, DrawnByOnePassAreAPassForEachViewAndLayer) {
    const ResolvedGraph g = good(graph(R"j("views": "lamps")j", "", layers("lampsViews")));
    ASSERT_EQ(g.passes.size(), 8u);
    for (uint32_t i = 0; i < 8; ++i) {
        const PassDecl& pass = pass_in(g, ("a#" + std::to_string(i)).c_str());
        EXPECT_EQ(pass.view, "lamps(" + std::to_string(i) + ")");
        EXPECT_EQ(pass.uses.at(pass.depth->use).range.layer, i);
        EXPECT_EQ(pass.uses.at(pass.depth->use).range.layers, 1u);
        EXPECT_FALSE(pass.state.viewport);
    }
    ASSERT_EQ(g.views.size(), 1u);
    EXPECT_EQ(g.views[0].name, "lamps");
    EXPECT_EQ(g.views[0].count, 8u);
}

TEST_F(ResolveViewLists, ReferencesMaySelectTheLayersThemselves) {
    const std::string text = graph(R"j("views": "lamps")j", "", layers("8"));
    const ResolvedGraph g =
        good(std::string(text).replace(text.find("\"shadow\", "), 9, "\"shadow.layer(7-view)\" ,"));
    EXPECT_EQ(use(g, "a#1", "depth").range.layer, 6u);
}

TEST_F(ResolveViewLists, NeedALayerForEachView) {
    const Diagnostic d = bad(graph(R"j("views": "lamps")j", "", layers("5")));
    EXPECT_EQ(d.code, "W192");
    expect_help(d, "\"layers\": \"lampsViews\"");
}

// The rectangles of a grid are disjoint and inside the attachment; the expected cells are written by hand.
TEST_F(ResolveViewLists, InRectanglesFormAGrid) {
    const ResolvedGraph g = good(graph(R"j("views": "lamps", "into": "rects")j"));
    ASSERT_EQ(g.passes.size(), 8u);
    for (uint32_t i = 0; i < 8; ++i) {
        const PassDecl& pass = pass_in(g, ("a#" + std::to_string(i)).c_str());
        ASSERT_TRUE(pass.state.viewport && pass.state.scissor);
        const RectPx cell{static_cast<int32_t>(i % 3 * 21), static_cast<int32_t>(i / 3 * 16), 21, 16};
        EXPECT_TRUE(*pass.state.viewport == cell) << i;
        EXPECT_TRUE(*pass.state.scissor == cell) << i;
    }
}

TEST_F(ResolveViewLists, InRectanglesShareOneRenderingScopeThatClearsOnce) {
    const ResolvedGraph g =
        good(R"j("imports": {"opaque": "drawlist", "lamps": "views"}, "resources": {"shadow": {"format": "d32f", "size": 64}},
        "passes": {"a": {"type": "raster", "draws": ["opaque"], "shader": "depthOnly", "views": "lamps", "into": "rects",
                         "depth": {"ref": "shadow", "clear": 1}}, "b": {"type": "readback", "in": ["shadow"]}})j");
    const FramePlan plan = compile(g, content_needs(g), {});
    uint32_t begun = 0, cleared = 0;
    for (const PassStep& step : plan.barriers.steps) {
        if (g.passes[step.pass].kind == PassKind::raster) begun += step.merges_render_pass ? 0 : 1;
        for (const AttachmentOps& ops : step.attachments) cleared += ops.load == LoadOp::clear ? 1 : 0;
    }
    EXPECT_EQ(plan.barriers.steps.size(), 9u);
    EXPECT_EQ(begun, 1u);
    EXPECT_EQ(cleared, 1u);
}

TEST_F(ResolveViewLists, MayGiveTheRectanglesThemselves) {
    const ResolvedGraph g = good(
        graph(R"j("views": "first", "into": "rects")j",
              R"j("views": {"first": {"of": "lamps", "count": 3, "rect": ["view * 8", 4, "8 + view", 16]}}, )j"));
    EXPECT_EQ(pass_in(g, "a#2").view, "lamps(2)");
    EXPECT_TRUE(pass_in(g, "a#2").state.viewport == (RectPx{16, 4, 10, 16}));
    imports.imports["lamps"].rects.assign(8, RectPx{3, 5, 7, 9});
    const ResolvedGraph given = good(graph(R"j("views": "lamps", "into": "rects")j"));
    EXPECT_TRUE(pass_in(given, "a#6").state.scissor == (RectPx{3, 5, 7, 9}));
}

TEST_F(ResolveViewLists, HaveRectanglesInsideTheAttachments) {
    const Diagnostic outside = bad(
        graph(R"j("views": "first", "into": "rects")j",
              R"j("views": {"first": {"of": "lamps", "rect": ["view * 8", 0, 8, 49]}}, )j"));
    EXPECT_EQ(outside.code, "W192");
    EXPECT_EQ(bad(graph(R"j("views": "lamps", "into": "rects")j", "", R"j({"format": "d32f", "size": 2})j")).code,
              "W192");
    EXPECT_EQ(bad(graph(R"j("views": "lamps", "into": "rects", "state": {"viewport": [0, 0, 4, 4]})j")).code,
              "W192");
    EXPECT_EQ(bad(graph(R"j("views": "lamps", "into": "rects", "covers": true)j")).code, "W192");
    EXPECT_EQ(bad(graph(R"j("views": "lamps", "into": "rects", "perFrame": 1, "clear": 0)j")).code, "W192");
    EXPECT_EQ(bad(graph(R"j("into": "rects")j")).code, "W109");
    EXPECT_EQ(bad(graph(R"j("views": "lamps", "into": "rects", "view": "camera")j")).code, "W109");
}

TEST_F(ResolveViewLists, MayBePartsOfOthers) {
    const std::string lists = R"j("views": {"near": {"of": "rest", "count": "n"}, "rest": {"of": "lamps", "first": 2}},
                                  "consts": {"n": 2}, )j";
    const ResolvedGraph g = good(graph(R"j("views": "near")j", lists, layers("nearViews")));
    EXPECT_EQ(resource_in(g, "shadow").layers, 2u);
    EXPECT_EQ(pass_in(g, "a#1").view, "lamps(3)");
    const ResolvedGraph rest = good(graph(R"j("view": "rest(5)")j", R"j("views": {"rest": {"of": "lamps", "first": 2}}, )j",
                                          layers("1")));
    EXPECT_EQ(pass_in(rest, "a").view, "lamps(7)");
    EXPECT_EQ(bad(graph(R"j("view": "rest(6)")j", R"j("views": {"rest": {"of": "lamps", "first": 2}}, )j")).code,
              "W109");
    EXPECT_EQ(bad(graph(R"j("view": "x(0)")j", R"j("views": {"x": {"of": "lamps", "first": 5, "count": 4}}, )j")).code,
              "W109");
}

TEST_F(ResolveViewLists, OfMirrorsAndCubesAreInThePlan) {
    const ResolvedGraph g =
        good(graph(R"j("view": "pond")j",
                   R"j("views": {"pond": {"of": "camera", "plane": [0, 2, 0, "3 - 1"]}, "unused": {"of": "camera"}}, )j"));
    EXPECT_EQ(pass_in(g, "a").view, "pond(0)");
    ASSERT_EQ(g.views.size(), 1u);
    EXPECT_EQ(g.views[0].source, ViewSource::mirror);
    EXPECT_EQ(g.views[0].of, "camera");
    EXPECT_EQ(g.views[0].plane, (std::array<double, 4>{0, 1, 0, 1}));
    const ResolvedGraph cube = good(
        graph(R"j("views": "probe")j",
              R"j("views": {"probe": {"of": "box", "plane": [1, 0, 0, 0]}, "box": {"cube": {"at": [1, 2, 3]}}}, )j",
              layers("probeViews")));
    EXPECT_EQ(resource_in(cube, "shadow").layers, 6u);
    ASSERT_EQ(cube.views.size(), 2u);
    EXPECT_EQ(cube.views[0].name, "box");
    EXPECT_EQ(cube.views[0].at, (std::array<double, 3>{1, 2, 3}));
    EXPECT_EQ(cube.views[1].of, "box");
}

TEST_F(ResolveViewLists, OfNoViewsDropThePass) {
    const ResolvedGraph g = good(R"j("imports": {"opaque": "drawlist", "none": "views"},
        "resources": {"shadow": {"format": "d32f", "size": 16}}, "passes": {
        "a": {"type": "raster", "draws": ["opaque"], "shader": "depthOnly", "depth": "shadow", "views": "none"}})j");
    EXPECT_TRUE(g.passes.empty());
}

TEST_F(ResolveViewLists, FaultsHaveOneMessage) {
    const auto with = [](const std::string& lists) { return graph(R"j("view": "x(0)")j", "\"views\": {" + lists + "}, "); };
    EXPECT_EQ(bad(with(R"j("x": {"of": "camra"})j")).code, "W118");
    EXPECT_EQ(bad(with(R"j("x": {"of": "y"}, "y": {"of": "x"})j")).code, "W191");
    EXPECT_EQ(bad(with(R"j("x": {"of": "x"})j")).code, "W191");
    EXPECT_EQ(bad(with(R"j("x": {"of": "y"}, "y": {"of": "y"})j")).code, "W191");
    EXPECT_EQ(bad(with(R"j("x": {"of": "camera", "plane": [0, 0, 0, 1]})j")).code, "W109");
    EXPECT_EQ(bad(with(R"j("x": {"of": "camera", "plane": [0, 0, 1]})j")).code, "W109");
    EXPECT_EQ(bad(with(R"j("x": {"of": "camera", "cube": {"at": [0, 0, 0]}})j")).code, "W109");
    EXPECT_EQ(bad(with(R"j("x": {"cube": {"at": [0, 0, 0], "near": 0}})j")).code, "W109");
    EXPECT_EQ(bad(with(R"j("x": {"cube": {}})j")).code, "W108");
    EXPECT_EQ(bad(with(R"j("x": {})j")).code, "W108");
    EXPECT_EQ(bad(with(R"j("x": {"of": "camera", "planes": 1})j")).code, "W101");
    EXPECT_EQ(bad(with(R"j("camera": {"of": "lamps"}, "x": {"of": "lamps"})j")).code, "W109");
    EXPECT_EQ(bad(graph(R"j("view": "lamps(0)")j", R"j("views": {"lamps": {"of": "camera"}}, )j")).code, "W109");
    EXPECT_EQ(bad(graph(R"j("views": "lampz")j")).code, "W118");
    EXPECT_EQ(bad(graph(R"j("views": "lamps", "repeat": {"view": "0..1"})j")).code, "W109");
    EXPECT_EQ(bad(graph(R"j("view": "lamps(0)")j", R"j("views": {"x": {"of": "lamps"}}, "consts": {"xViews": 1}, )j")).code,
              "W109");
    EXPECT_EQ(bad(R"j("imports": {"opaque": "drawlist", "lamps": "views"}, "resources": {"c": "rgba8"}, "passes": {
        "a": {"type": "raster", "draws": ["opaque"], "shader": "mesh", "out": {"color": "lamps"}}})j").code,
              "W103");
}

// All views of a pass with "rest" that share an attachment must run in the same frames, because the first clears.
TEST_F(ResolveViewLists, InRectanglesRestTogether) {
    const ResolvedGraph g = good(R"j("imports": {"opaque": "drawlist", "lamps": "views"},
        "resources": {"shadow": {"format": "d32f", "size": 64, "keep": true}}, "passes": {
        "a": {"type": "raster", "draws": ["opaque"], "shader": "depthOnly", "depth": {"ref": "shadow", "clear": 0},
              "views": "lamps", "into": "rects", "rest": true}})j");
    EXPECT_NE(pass_in(g, "a#0").rest_unit, kNoId);
    for (const PassDecl& pass : g.passes) EXPECT_EQ(pass.rest_unit, g.passes.front().rest_unit) << pass.name;
}

}  // namespace
}  // namespace weft::test

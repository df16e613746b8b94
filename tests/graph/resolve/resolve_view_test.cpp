// Tests the camera views of passes, views with an index, and views that the program provides.
#include <algorithm>

#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

class ResolveView : public ResolveTest {
 protected:
    ResolveView() {
        shaders["mesh"] = fragment({});
        imports.views = {"camera", "sun"};
        imports.imports["sun"] = {.name = "sun", .kind = ImportKind::views, .views = 3};
        imports.numbers = {{"suns", 2}};
    }
    static std::string graph(const std::string& view, const std::string& keys = "",
                             const std::string& more = "") {
        return R"j("imports": {"opaque": "drawlist"}, "resources": {"shadow": {"format": "d32f", "layers": 3}}, )j" +
               more + R"j("passes": {"a": {"type": "raster", "draws": ["opaque"], "shader": "mesh",
               "depth": "shadow.layer(0)", "view": ")j" +
               view + "\"" + keys + "}}";
    }
};

TEST_F(ResolveView, OfAPassIsTheCameraOrWhatItSays) {
    EXPECT_EQ(pass_in(good(graph("camera")), "a").view, "camera");
    EXPECT_EQ(pass_in(good(graph("sun(2)")), "a").view, "sun(2)");
    EXPECT_EQ(pass_in(good(graph("sun( 4 / 2 - 1 )")), "a").view, "sun(1)");
}

TEST_F(ResolveView, OfARepeatFollowsItsIndex) {
    const ResolvedGraph g = good(graph("sun(2-i)", R"j(, "repeat": {"i": "0..suns"}, "partial": true)j"));
    EXPECT_EQ(pass_in(g, "a#0").view, "sun(2)");
    EXPECT_EQ(pass_in(g, "a#2").view, "sun(0)");
}

TEST_F(ResolveView, ThatIsNotThere) {
    const Diagnostic slip = bad(graph("camra"));
    EXPECT_EQ(slip.code, "W118");
    expect_help(slip, "did you mean \"camera\"");
    const Diagnostic unnumbered = bad(graph("sun"));
    EXPECT_EQ(unnumbered.code, "W118");
    expect_help(unnumbered, "from 0 to 2: \"view\": \"sun(0)\"");
    const Diagnostic numbered = bad(graph("camera(0)"));
    EXPECT_EQ(numbered.code, "W118");
    expect_help(numbered, "there is only one such view: \"view\": \"camera\"");
    const Diagnostic beyond = bad(graph("sun(3)"));
    EXPECT_EQ(beyond.code, "W109");
    expect_help(beyond, "0 to 2");
    EXPECT_EQ(bad(graph("sun(1 / 2)")).code, "W109");
    EXPECT_EQ(bad(graph("sun(which)")).code, "W107");
    EXPECT_EQ(bad(graph("sun(1")).code, "W106");
    EXPECT_EQ(bad(graph("sun(1)s")).code, "W106");
}

TEST_F(ResolveView, OfTooFewRoundsIsReportedOnce) {
    EXPECT_EQ(bad(graph("sun(i)", R"j(, "repeat": {"i": "0..5"}, "partial": true)j")).code, "W109");
}

TEST_F(ResolveView, NumberCostsAGraph) {
    const ResolvedGraph g = good(graph("sun(which)", "", R"j("params": {"which": 1}, )j"));
    ASSERT_EQ(g.params.size(), 1u);
    EXPECT_EQ(g.params[0].cost, ParamCost::graph);
}

TEST_F(ResolveView, NumbersOfTheProgramGiveWayToTheAuthors) {
    EXPECT_EQ(pass_in(good(graph("sun(suns)")), "a").view, "sun(2)");
    EXPECT_EQ(pass_in(good(graph("sun(suns)", "", R"j("params": {"suns": 1}, )j")), "a").view, "sun(1)");
    EXPECT_EQ(pass_in(good(graph("sun(suns)", "", R"j("consts": {"suns": 0}, )j")), "a").view, "sun(0)");
}

}  // namespace
}  // namespace weft::test

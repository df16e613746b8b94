// Tests raster passes without a draw list: the numbers of vertices and instances, and the shader inputs that
// such passes cannot provide.
#include <algorithm>

#include "graph/report/plan_summary.h"
#include "tests/graph/resolve/resolve_fixture.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

class ResolveProcedural : public ResolveTest {
 protected:
    ResolveProcedural() { shaders["star"] = fragment({"hdr"}); }
    static std::string graph(const std::string& draws, const std::string& more = "") {
        return R"j("params": {"lights": {"default": 40, "range": [0, 1e9]}}, "sizes": {"tiles": "output / 16"},
"resources": {"hdr": "rgba16f"}, "passes": {
"stars": {"type": "raster", "shader": "star", "out": ["hdr"], "draws": )j" +
               draws + more + "}}";
    }
    PassDecl stars(const std::string& draws) { return pass_in(good(graph(draws)), "stars"); }
};

TEST_F(ResolveProcedural, CountsAreExpressions) {
    const PassDecl both = stars(R"j({"vertices": "3 * 4", "instances": "lights"})j");
    EXPECT_EQ(both.vertices, 12u);
    EXPECT_EQ(both.instances, 40u);
    EXPECT_TRUE(both.draw_lists.empty());
    EXPECT_EQ(both.view, "camera");
    EXPECT_EQ(stars(R"j({"vertices": 7})j").instances, 1u);
    EXPECT_EQ(stars(R"j({"vertices": "tiles.y"})j").vertices, 23u) << "22.5, rounded up";
}

TEST_F(ResolveProcedural, AParameterThatCountsChangesTheGraph) {
    const ResolvedGraph g = good(graph(R"j({"vertices": 3, "instances": "lights"})j"));
    ASSERT_EQ(g.params.size(), 1u);
    EXPECT_EQ(g.params[0].cost, ParamCost::graph);
}

TEST_F(ResolveProcedural, ThePlanSaysHowMany) {
    const ResolvedGraph g = good(graph(R"j({"vertices": 3, "instances": 5})j"));
    CompileOptions options;
    options.keep_all_passes = true;
    const FramePlan plan = compile(g, content_needs(g), options);
    const std::vector<std::string> facts = summarize_pass(plan, 0);
    EXPECT_NE(std::ranges::find(facts, "draws 3 vertices x 5 as seen by camera"), facts.end());
}

TEST_F(ResolveProcedural, CountsBeyondReason) {
    for (const char* draws : {R"j({"vertices": 0})j", R"j({"vertices": 3, "instances": 0})j",
                              R"j({"vertices": 3, "instances": -2})j", R"j({"vertices": 16777217})j",
                              R"j({"vertices": "tiles"})j"}) {
        const Diagnostic d = bad(graph(draws));
        EXPECT_EQ(d.code, "W114") << draws;
        EXPECT_EQ(d.line, 3u) << draws;
    }
    expect_help(bad(graph(R"j({"vertices": 0})j")), "1 to 16777216");
    expect_help(bad(graph(R"j({"vertices": "tiles"})j")), ".x or .y");
}

TEST_F(ResolveProcedural, KeysThatAreNot) {
    const Diagnostic slip = bad(graph(R"j({"vertexes": 3})j"));
    EXPECT_EQ(slip.code, "W101");
    expect_help(slip, "did you mean \"vertices\"");
    EXPECT_EQ(bad(graph(R"j({"instances": 3})j")).code, "W108");
    EXPECT_EQ(bad(graph(R"j({"list": "opaque", "vertices": 3})j")).code, "W101");
    EXPECT_EQ(bad(graph(R"j({"vertices": 3})j", R"j(, "state": {"cull": "material"})j")).code, "W109");
}

TEST_F(ResolveProcedural, NothingOfAListIsThere) {
    StageVariable input;
    input.name = "position";
    shaders["star"].interface.vertex_inputs = {input};
    const Diagnostic vertex = bad(graph(R"j({"vertices": 3})j"));
    EXPECT_EQ(vertex.code, "W167");
    EXPECT_NE(vertex.message.find("vertex input \"position\""), std::string::npos) << vertex.message;
    shaders["star"].interface.vertex_inputs.clear();
    ShaderBinding material;
    material.name = "material";
    material.set = 2;
    shaders["star"].interface.bindings.push_back(material);
    EXPECT_EQ(bad(graph(R"j({"vertices": 3})j")).code, "W167");
}

}  // namespace
}  // namespace weft::test

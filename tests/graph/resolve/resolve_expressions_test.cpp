// Tests expressions in the places of a graph that allow a number, for example in pipeline states and clear
// values. Also tests ParamCost: the work that a change of a parameter causes.
#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

class ResolveExpressions : public ResolveTest {
 protected:
    ResolveExpressions() {
        shaders["make.comp"] = compute({image_out("dst")});
        shaders["mix.frag"] = fragment({"color"}, {sampled("src")});
    }

    // Returns a graph whose fullscreen pass "p" draws into x with this pipeline state.
    std::string drawing(const std::string& state, const std::string& before = "") {
        const bool stencil = state.find("stencil") != std::string::npos;
        return before + R"j("params": {"n": 3}, "sizes": {"half": "output / 2"},
          "resources": {"s": "rgba16f", "x": "rgba16f")j" +
               (stencil ? R"j(, "z": "d32f_s8"},)j" : "},") + R"j(
          "passes": {"c": {"type": "clear", "out": ["s"], "clear": ["n / 4", 0, "n * 2", 1]},
                     "p": {"type": "fullscreen", "shader": "mix.frag", "in": {"src": "s"}, "out": {"color": "x"},
                           "clear": 0, "state": )j" +
               state + (stencil ? R"j(, "depth": "z"}})j" : "}}");
    }
};

TEST_F(ResolveExpressions, OfStates) {
    const ResolvedGraph g = good(drawing(
        R"j({"scissor": ["half.x", 0, "half.x", "half.y"], "viewport": [0, "-n", 64, "n * 8"],
             "depthBias": {"constant": "n / 2", "slope": 0.5},
             "depth": "none", "stencil": {"reference": "n + 1", "pass": "replace"}})j"));
    const RasterState& state = pass_in(g, "p").state;
    EXPECT_EQ(state.scissor, (RectPx{320, 0, 320, 180}));
    EXPECT_EQ(state.viewport, (RectPx{0, -3, 64, 24}));
    EXPECT_EQ(state.depth_bias_constant, 1.5f);
    EXPECT_EQ(state.depth_bias_slope, 0.5f);
    EXPECT_EQ(state.stencil_front.reference, 4);
    EXPECT_EQ(state.stencil_back.reference, 4);
    EXPECT_EQ(state.stencil_back.pass, StencilOp::replace);
}

TEST_F(ResolveExpressions, OfColoursFollowParameters) {
    EXPECT_EQ(pass_in(good(drawing("{}")), "c").clear, (std::array<float, 4>{0.75f, 0, 6, 1}));
    params = {{"n", 4}};
    EXPECT_EQ(pass_in(good(drawing("{}")), "c").clear, (std::array<float, 4>{1, 0, 8, 1}));
}

TEST_F(ResolveExpressions, OutOfRangeOnceKnown) {
    const Diagnostic negative = bad(drawing(R"j({"scissor": ["0 - n", 0, 8, 8]})j"));
    EXPECT_EQ(negative.code, "W109");
    EXPECT_NE(negative.message.find("is -3"), std::string::npos) << negative.message;
    EXPECT_EQ(
        bad(drawing(R"j({"depth": "none", "stencil": {"reference": "n / 2", "pass": "replace"}})j")).code,
        "W109");
    EXPECT_EQ(bad(drawing(R"j({"depthBias": {"constant": "half"}})j")).code, "W106");
}

TEST_F(ResolveExpressions, OfHistorySamplesAndFrames) {
    const std::string body =
        R"j("params": {"back": 2}, "consts": {"two": "1 + 1", "four": "two * 2"}, "frames": "back * 8",
      "resources": {"a": {"format": "rgba16f", "history": "back", "firstFrame": "four"}, "m": {"format": "r8", "samples": "four"}},
      "passes": {"p": {"type": "compute", "shader": "make.comp", "out": {"dst": "a"}}, "q": {"type": "clear", "out": ["m"]}})j";
    const ResolvedGraph g = good(body);
    EXPECT_EQ(g.frames, 16u);
    EXPECT_EQ(resource_in(g, "a").history, 2u);
    EXPECT_NE(find_resource(g, "a[-2]"), kNoId);
    EXPECT_EQ(resource_in(g, "a[-1]").first_frame, (std::array<float, 4>{4, 4, 4, 4}));
    params = {{"back", 0}};
    EXPECT_EQ(find_resource(g, "a[-3]"), kNoId);
    params = {{"back", 17}};
    const Diagnostic d = bad(body);
    EXPECT_EQ(d.code, "W109");
    expect_help(d, "0 to 16");
}

TEST_F(ResolveExpressions, AHistoryOfNoneIsNone) {
    params = {{"back", 0}};
    const ResolvedGraph g = good(R"j("params": {"back": 2},
      "resources": {"a": {"format": "rgba16f", "history": "back"}},
      "passes": {"p": {"type": "compute", "shader": "make.comp", "out": {"dst": "a"}}})j");
    EXPECT_EQ(resource_in(g, "a").lifetime, ResourceLifetime::transient);
}

TEST_F(ResolveExpressions, ConstantsInACircleAndOfSizes) {
    EXPECT_EQ(bad(R"j("consts": {"a": "b", "b": "a + 1"}, "passes": {})j").code, "W106");
    EXPECT_EQ(bad(R"j("consts": {"a": "output"}, "passes": {})j").code, "W106");
}

TEST_F(ResolveExpressions, SoManySlicesAFrame) {
    const auto slices = [&](const std::string& each) {
        const ResolvedGraph g = good(R"j("params": {"rate": 2},
          "resources": {"a": {"format": "rgba16f", "layers": 5, "keep": true}},
          "passes": {"p": {"type": "compute", "shader": "make.comp", "repeat": {"i": "0..4"}, "perFrame": )j" +
                                     each + R"j(, "out": {"dst": "a.layer(i)"}}})j");
        std::string text;
        for (const PassDecl& pass : g.passes)
            text += std::to_string(pass.frame_slice) + "/" + std::to_string(pass.frame_slices) + " ";
        return text;
    };
    EXPECT_EQ(slices("true"), "0/5 1/5 2/5 3/5 4/5 ");
    EXPECT_EQ(slices("\"rate\""), "0/3 0/3 1/3 1/3 2/3 ");
    EXPECT_EQ(slices("9"), "0/1 0/1 0/1 0/1 0/1 ");
    EXPECT_EQ(slices("false"), "0/0 0/0 0/0 0/0 0/0 ");
}

TEST_F(ResolveExpressions, WhatAParameterCosts) {
    shaders["make.comp"] = with_params(compute({image_out("dst")}), {member("live")});
    const ResolvedGraph g = good(R"j("params": {"live": 1, "scale": 1, "unused": 1},
      "sizes": {"s": "output * scale"}, "resources": {"a": {"format": "rgba16f", "size": "s"}},
      "passes": {"p": {"type": "compute", "shader": "make.comp", "out": {"dst": "a"}},
                 "r": {"type": "readback", "in": ["a"]}})j");
    ASSERT_EQ(g.params.size(), 3u);
    EXPECT_EQ(g.params[0].cost, ParamCost::live);
    EXPECT_EQ(g.params[1].cost, ParamCost::graph) << "through the size";
    EXPECT_EQ(g.params[2].cost, ParamCost::nothing);
    ASSERT_EQ(warnings.size(), 1u) << to_text(warnings);
    EXPECT_EQ(warnings[0].code, "W132");
}

}  // namespace
}  // namespace weft::test

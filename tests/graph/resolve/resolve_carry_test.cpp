// Tests resources with both `history` and `keep`: Weft copies the content of the last frame only if a pass
// needs it.
#include <algorithm>

#include "graph/resolve/cull.h"
#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

class ResolveCarry : public ResolveTest {
 protected:
    ResolveCarry() {
        shaders["make.comp"] = compute({image_out("dst")});
        shaders["copy.comp"] = compute({sampled("src"), image_out("dst")});
        shaders["pair.comp"] = compute({sampled("now"), sampled("before"), image_out("dst")});
        shaders["update.comp"] = compute({image_in_out("x")});
        shaders["add.frag"] = fragment({"color"});
    }

    // Returns a graph with the image "x", which has `history` and `keep`, and the given passes. A pass "show"
    // reads both "x" and "x[-1]".
    static std::string graph(const std::string& passes, const std::string& more = "") {
        return R"j("resources": {"y": "rgba16f", "x": {"format": "rgba16f", "history": 1, "keep": true)j" +
               more + R"j(}}, "passes": {)j" + passes + R"j(
"show": {"type": "compute", "shader": "pair.comp", "in": {"now": "x.mip(0)", "before": "x[-1].mip(0)"},
         "out": {"dst": "y"}}})j";
    }

    [[nodiscard]] static bool has_pass(const ResolvedGraph& graph, const char* name) {
        return find_pass(graph, name) != kNoId;
    }
};

TEST_F(ResolveCarry, AReadSeesTheLastFrame) {
    observed = {"y"};
    const ResolvedGraph g = good(graph(""));
    EXPECT_EQ(seen(g, "show", "now"), "carry:x");
    EXPECT_EQ(seen(g, "show", "before"), "before");
    EXPECT_EQ(seen(g, "carry:x", "src"), "before");
    const PassDecl& carry = pass_in(g, "carry:x");
    EXPECT_TRUE(carry.carries);
    EXPECT_EQ(carry.kind, PassKind::copy);
    EXPECT_EQ(g.resources[carry.uses[0].resource].name, "x[-1]");
    EXPECT_EQ(g.resources[carry.uses[1].resource].name, "x");
    EXPECT_TRUE(cull(g).live_passes[find_pass(g, "carry:x")]);
    EXPECT_TRUE(warnings.empty()) << to_text(warnings);
}

TEST_F(ResolveCarry, AChangeInPlaceContinuesTheLastFrame) {
    const ResolvedGraph g = good(
        graph(R"j("up": {"type": "compute", "shader": "update.comp", "in": {"x": "x"}, "out": {"x": "x"}},)j"));
    EXPECT_EQ(seen(g, "up", "x"), "carry:x");
    EXPECT_EQ(seen(g, "show", "now"), "up");
    EXPECT_TRUE(has_edge(g, "carry:x", "up", EdgeKind::raw));
}

TEST_F(ResolveCarry, BlendingContinuesTheLastFrame) {
    const ResolvedGraph g = good(graph(
        R"j("b": {"type": "fullscreen", "shader": "add.frag", "out": {"color": "x"}, "state": {"blend": "add"}},)j"));
    EXPECT_EQ(seen(g, "b", "color"), "carry:x");
    EXPECT_EQ(use(g, "b", "color").access, Access::color_read_write);
}

TEST_F(ResolveCarry, AShaderThatReadsItsOutputContinuesTheLastFrame) {
    const ResolvedGraph g =
        good(graph(R"j("up": {"type": "compute", "shader": "update.comp", "out": {"x": "x"}},)j"));
    EXPECT_EQ(seen(g, "up", "x"), "carry:x");
    EXPECT_EQ(use(g, "up", "x").access, Access::storage_read_write);
}

TEST_F(ResolveCarry, NoCopyIfTheFirstWriterReplacesAll) {
    observed = {"y"};
    for (const char* writer :
         {R"j("w": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}},)j",
          R"j("w": {"type": "fullscreen", "shader": "add.frag", "out": {"color": "x"}},)j",
          R"j("w": {"type": "clear", "out": ["x"], "clear": 1},
              "b": {"type": "fullscreen", "shader": "add.frag", "out": {"color": "x"}, "state": {"blend": "add"}},)j"}) {
        const ResolvedGraph g = good(graph(writer));
        EXPECT_FALSE(has_pass(g, "carry:x")) << writer;
        EXPECT_EQ(seen(g, "show", "before"), "before");
        for (const EdgeDecl& edge : g.edges) {
            ASSERT_LT(edge.from, g.passes.size());
            ASSERT_LT(edge.to, g.passes.size());
        }
    }
}

// As for any other image, a raster pass without "partial" and blending clears the image.
TEST_F(ResolveCarry, ARasterPassClearsAsEver) {
    shaders["add"] = fragment({"color"});
    const ResolvedGraph g = good(graph(
        R"j("d": {"type": "raster", "shader": "add", "draws": {"vertices": 3}, "out": {"color": "x"}},)j"));
    EXPECT_EQ(use(g, "d", "color").access, Access::color_write);
    EXPECT_FALSE(has_pass(g, "carry:x"));
}

// Only the mips that a pass sees, or that no pass writes, are copied.
TEST_F(ResolveCarry, OnlyTheNeededPartsAreCopied) {
    const ResolvedGraph g =
        good(graph(R"j("w": {"type": "compute", "shader": "make.comp", "out": {"dst": "x.mip(0)"}},
                       "v": {"type": "compute", "shader": "make.comp", "out": {"dst": "x.mip(3)"}},)j",
                   R"j(, "mips": 4)j"));
    const UseDecl& to = use(g, "carry:x", "dst");
    EXPECT_EQ(to.range.mip, 1u);
    EXPECT_EQ(to.range.mips, 2u);
    EXPECT_EQ(use(g, "carry:x", "src").range, to.range);
    EXPECT_EQ(use(g, "carry:x", "src").sources.front().range, to.range);
}

TEST_F(ResolveCarry, APartialWriterNeedsTheCopy) {
    const ResolvedGraph g = good(graph(
        R"j("w": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}, "partial": true},)j"));
    EXPECT_EQ(seen(g, "w", "dst"), "carry:x");
}

// The oldest of several earlier frames is not what the copy reads.
TEST_F(ResolveCarry, TheCopyReadsTheNewestOfSeveralFrames) {
    const std::string text = R"j("resources": {"y": "rgba16f",
      "x": {"format": "rgba16f", "history": 2, "keep": true}}, "passes": {
      "c": {"type": "compute", "shader": "copy.comp", "in": {"src": "x"}, "out": {"dst": "y"}}})j";
    const ResolvedGraph g = good(text);
    EXPECT_EQ(g.resources[use(g, "carry:x", "src").resource].name, "x[-1]");
    EXPECT_EQ(use(g, "carry:x", "src").history, 1u);
}

TEST_F(ResolveCarry, BuffersToo) {
    shaders["step.comp"] = compute({buffer("b", true, true)});
    const ResolvedGraph g =
        good(R"j("resources": {"b": {"buffer": "vec4", "count": 8, "history": 1, "keep": true}}, "passes": {
      "s": {"type": "compute", "shader": "step.comp", "groups": 1, "out": {"b": "b"}}})j");
    EXPECT_EQ(seen(g, "s", "b"), "carry:b");
}

TEST_F(ResolveCarry, TwoFullWritersStillNeedAnOrder) {
    const Diagnostic d =
        bad(graph(R"j("v": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}},
                      "w": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}},)j"));
    EXPECT_EQ(d.code, "W111");
}

TEST_F(ResolveCarry, PassesThatDoNotRunInEveryFrameCannotWriteIt) {
    const Diagnostic rest = bad(graph(
        R"j("w": {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}, "rest": true},)j"));
    EXPECT_EQ(rest.code, "W188");
    EXPECT_NE(rest.message.find("moves on in every frame"), std::string::npos) << rest.message;
    const Diagnostic sliced = bad(R"j("resources": {"y": "rgba16f",
      "x": {"format": "rgba16f", "history": 1, "keep": true, "layers": 2}}, "passes": {
      "w": {"type": "compute", "shader": "make.comp", "repeat": {"i": "0..1"}, "perFrame": 1,
            "out": {"dst": "x.layer(i)"}},
      "c": {"type": "compute", "shader": "copy.comp", "in": {"src": "x.layer(0)"}, "out": {"dst": "y"}}})j");
    EXPECT_EQ(sliced.code, "W124");
}

TEST_F(ResolveCarry, RoundsOfAGroupCannotWriteIt) {
    const Diagnostic d = bad(R"j("resources": {"y": "rgba16f",
      "x": {"format": "rgba16f", "history": 1, "keep": true, "layers": 2}},
      "groups": {"g": {"repeat": {"i": "0..1"}, "perFrame": 1, "passes": {
        "w": {"type": "compute", "shader": "make.comp", "out": {"dst": "x.layer(i)"}}}}},
      "passes": {
        "c": {"type": "compute", "shader": "copy.comp", "in": {"src": "x.layer(0)"}, "out": {"dst": "y"}}})j");
    EXPECT_EQ(d.code, "W188") << d.message;
}

// A reference to a removed pass sees the content of the last frame.
TEST_F(ResolveCarry, ARemovedWriterLeavesTheLastFrame) {
    const ResolvedGraph g = good(R"j("resources": {"y": "rgba16f",
      "x": {"format": "rgba16f", "history": 1, "keep": true}}, "passes": {
      "w": {"type": "compute", "shader": "update.comp", "in": {"x": "x"}, "out": {"x": "x"}, "if": false},
      "c": {"type": "compute", "shader": "copy.comp", "in": {"src": "x@w"}, "out": {"dst": "y"}},
      "d": {"type": "compute", "shader": "copy.comp", "in": {"src": "x"}, "out": {"dst": "y@c"}}})j");
    EXPECT_EQ(seen(g, "c", "src"), "carry:x");
}

}  // namespace
}  // namespace weft::test

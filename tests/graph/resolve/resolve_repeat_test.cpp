// Tests repeated passes: the names and indices of their iterations, and which iteration's output each
// iteration reads.
#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

class ResolveRepeat : public ResolveTest {
 protected:
    ResolveRepeat() {
        shaders["make.comp"] = compute({image_out("dst")});
        shaders["copy.comp"] = compute({sampled("src"), image_out("dst")});
        shaders["up.comp"] = compute({sampled("src"), image_in_out("base")});
        shaders["update.comp"] = compute({image_in_out("x")});
        shaders["fill.comp"] = compute({buffer("dst", false, true)});
    }

    // Returns a graph with the image "x" of 640x360 px and 10 mip levels. Pass "make" writes level 0.
    // Repeated pass "down" writes level i in iteration i and, by default, reads level i - 1.
    static std::string pyramid(const std::string& repeat = R"j({"i": "1..mips(x)-1"})j",
                               const std::string& src = "x.mip(i-1)", const std::string& more = "") {
        return R"j("resources": {"x": {"format": "rgba16f", "mips": "full"}}, "passes": {
"make": {"type": "compute", "shader": "make.comp", "out": {"dst": "x.mip(0)"}},)j" +
               more + R"j(
"down": {"type": "compute", "shader": "copy.comp", "repeat": )j" +
               repeat + R"j(, "in": {"src": ")j" + src + R"j("}, "out": {"dst": "x.mip(i)"}}})j";
    }
    static std::vector<std::string> names(const ResolvedGraph& g) {
        std::vector<std::string> found;
        for (const PassDecl& pass : g.passes) found.push_back(pass.name);
        return found;
    }
};

TEST_F(ResolveRepeat, OnePassForEachIndex) {
    const ResolvedGraph g = good(pyramid());
    ASSERT_EQ(g.passes.size(), 10u);
    EXPECT_EQ(g.passes[0].name, "down#1");
    EXPECT_EQ(use(g, "down#3", "src").range.mip, 2u);
    EXPECT_EQ(use(g, "down#3", "dst").range.mip, 3u);
    EXPECT_EQ(seen(g, "down#1", "src"), "make");
    EXPECT_EQ(seen(g, "down#9", "src"), "down#8");
    EXPECT_EQ(pass_in(g, "down#1").groups, (std::array<uint32_t, 3>{40, 23, 1}));
}

TEST_F(ResolveRepeat, EmptyRangesAndSteps) {
    EXPECT_EQ(good(pyramid(R"j({"i": "3..2"})j")).passes.size(), 1u);
    EXPECT_EQ(names(good(pyramid(R"j({"i": "2..1 by -1"})j", "x.mip(0)"))),
              (std::vector<std::string>{"down#1", "down#2", "make"}));
    EXPECT_EQ(good(pyramid(R"j({"i": "1..2 by -1"})j")).passes.size(), 1u);
    EXPECT_EQ(names(good(pyramid(R"j({"i": "1..5 by 2"})j", "x.mip(0)"))),
              (std::vector<std::string>{"down#1", "down#3", "down#5", "make"}));
}

TEST_F(ResolveRepeat, NestedRepeatsRunTheOuterFirst) {
    const ResolvedGraph g = good(R"j("resources": {"x": {"format": "rgba16f", "layers": 9}}, "passes": {
      "p": {"type": "compute", "shader": "make.comp", "repeat": {"j": "1..2", "i": "0..j"},
            "out": {"dst": "x.layer(j * 3 + i)"}}})j");
    EXPECT_EQ(names(g), (std::vector<std::string>{"p#1.0", "p#1.1", "p#2.0", "p#2.1", "p#2.2"}));
    EXPECT_EQ(use(g, "p#2.1", "dst").range.layer, 7u);
}

TEST_F(ResolveRepeat, DownAndUpAgain) {
    const ResolvedGraph g = good(pyramid(R"j({"i": "1..mips(x)-1"})j", "x@down.mip(i-1)", R"j(
"up": {"type": "compute", "shader": "up.comp", "repeat": {"i": "mips(x)-2..0 by -1"},
       "in": {"src": "x.mip(i+1)", "base": "x.mip(i)"}, "out": {"base": "x.mip(i)"}},
"show": {"type": "readback", "in": ["x.mip(0)"]}, "middle": {"type": "readback", "in": ["x@down.mip(4)"]},)j"));
    EXPECT_EQ(seen(g, "down#1", "src"), "make") << "down doesn't write mip 0: what was there before it";
    EXPECT_EQ(seen(g, "down#5", "src"), "down#4");
    EXPECT_EQ(seen(g, "up#8", "src"), "down#9");
    EXPECT_EQ(seen(g, "up#8", "base"), "down#8");
    EXPECT_EQ(seen(g, "up#0", "src"), "up#1");
    EXPECT_EQ(seen(g, "up#0", "base"), "make");
    EXPECT_EQ(seen(g, "show", "x"), "up#0");
    EXPECT_EQ(seen(g, "middle", "x"), "down#4");
}

TEST_F(ResolveRepeat, RoundsOnOneImageFollowEachOther) {
    const ResolvedGraph g = good(R"j("resources": {"x": "rgba16f"}, "passes": {
      "make": {"type": "clear", "out": ["x"]},
      "round": {"type": "compute", "shader": "update.comp", "repeat": {"i": "0..11"}, "in": ["x"], "out": ["x"]},
      "show": {"type": "readback", "in": ["x"]}})j");
    EXPECT_EQ(seen(g, "round#0", "x"), "make");
    EXPECT_EQ(seen(g, "round#2", "x"), "round#1");
    EXPECT_EQ(seen(g, "round#10", "x"), "round#9") << "in the order of the index, not of the names";
    EXPECT_EQ(seen(g, "show", "x"), "round#11");
}

TEST_F(ResolveRepeat, APinOfItselfSeesEarlierRounds) {
    const ResolvedGraph g = good(R"j("resources": {"x": {"format": "rgba16f", "layers": 2}}, "passes": {
      "make": {"type": "clear", "out": {"dst": "x.layer(0)"}},
      "round": {"type": "compute", "shader": "copy.comp", "repeat": {"i": "0..3"},
                "in": {"src": "x@round.layer(i % 2)"}, "out": {"dst": "x.layer((i + 1) % 2)"}}})j");
    EXPECT_EQ(seen(g, "round#0", "src"), "make");
    EXPECT_EQ(seen(g, "round#1", "src"), "round#0");
    EXPECT_EQ(seen(g, "round#2", "src"), "round#1");
    EXPECT_EQ(seen(g, "round#3", "src"), "round#2");
    EXPECT_TRUE(has_edge(g, "round#0", "round#1", EdgeKind::war) ||
                has_edge(g, "round#0", "round#1", EdgeKind::raw));
}

TEST_F(ResolveRepeat, AfterMeansAllOfThem) {
    const ResolvedGraph g =
        good(R"j("resources": {"x": {"format": "rgba16f", "layers": 2}, "y": "rgba16f"}, "passes": {
      "p": {"type": "compute", "shader": "make.comp", "repeat": {"i": "0..1"}, "out": {"dst": "x.layer(i)"}},
      "late": {"type": "clear", "out": ["y"], "after": ["p"]}})j");
    EXPECT_TRUE(has_edge(g, "p#0", "late", EdgeKind::after));
    EXPECT_TRUE(has_edge(g, "p#1", "late", EdgeKind::after));
}

TEST_F(ResolveRepeat, IndicesAreNamesLikeOthers) {
    shaders["make.comp"] = with_constants(
        with_params(compute({image_out("dst")}), {member("i", 1, ScalarType::i32), member("twice")}),
        {{"i", ScalarType::u32}});
    const ResolvedGraph g = good(R"j("resources": {"x": {"format": "rgba16f", "layers": 4}}, "passes": {
      "p": {"type": "compute", "shader": "make.comp", "repeat": {"i": "0..3"}, "params": {"twice": "2 * i"},
            "groups": ["i + 1", 1, 1], "out": {"dst": "x.layer(i)"}}})j");
    const PassDecl& p = pass_in(g, "p#3");
    EXPECT_EQ(p.params[0].value[0], 3.0);
    EXPECT_EQ(p.params[1].value[0], 6.0);
    EXPECT_EQ(p.groups[0], 4u);
    ASSERT_EQ(p.spec_values.size(), 1u);
    EXPECT_EQ(p.spec_values[0].bits, 3u);
}

TEST_F(ResolveRepeat, ConditionsMaySpeakOfTheIndex) {
    const ResolvedGraph g = good(R"j("resources": {"x": {"format": "rgba16f", "layers": 4}}, "passes": {
      "p": {"type": "compute", "shader": "make.comp", "repeat": {"i": "0..3"}, "if": "i % 2",
            "out": {"dst": "x.layer(i)"}}})j");
    EXPECT_EQ(names(g), (std::vector<std::string>{"p#1", "p#3"}));
}

// Returns a graph with an image of six layers and the repeated pass "p" with `perFrame`: frame 0 runs
// all iterations, and each later frame runs one iteration. `keys` are further members of the image.
std::string slices(const std::string& keys, const std::string& repeat = R"j("repeat": {"i": "0..5"}, )j") {
    return R"j("resources": {"x": {"format": "rgba16f", "layers": 6)j" + keys + R"j(}}, "passes": {
      "p": {"type": "compute", "shader": "make.comp", )j" +
           repeat + R"j("perFrame": true, "out": {"dst": "x.layer(0)"}}})j";
}

TEST_F(ResolveRepeat, PassesMayBeSlicedOverFrames) {
    const ResolvedGraph g = good(slices(R"j(, "keep": true)j"));
    ASSERT_EQ(g.passes.size(), 6u);
    for (uint32_t i = 0; i < 6; ++i) {
        EXPECT_EQ(g.passes[i].frame_slice, i);
        EXPECT_EQ(g.passes[i].frame_slices, 6u);
    }
    EXPECT_TRUE(runs_in_frame(g.passes[2], 0));
    EXPECT_FALSE(runs_in_frame(g.passes[2], 1));
    EXPECT_TRUE(runs_in_frame(g.passes[2], 8));
}

TEST_F(ResolveRepeat, ContentOfSlicesMustPersist) {
    const Diagnostic lost = bad(slices(""));
    EXPECT_EQ(lost.code, "W124");
    expect_help(lost, R"j(add "keep": true to resource "x")j");
    EXPECT_EQ(bad(slices(R"j(, "history": 1)j")).code, "W124");
    const Diagnostic alone = bad(slices(R"j(, "keep": true)j", ""));
    EXPECT_EQ(alone.code, "W124");
    expect_help(alone, "\"repeat\"");
}

TEST_F(ResolveRepeat, ReadersOfAnEmptyRepeat) {
    const Diagnostic d = bad(R"j("resources": {"x": "rgba16f"}, "passes": {
      "p": {"type": "compute", "shader": "make.comp", "repeat": {"i": "1..0"}, "out": {"dst": "x"}},
      "show": {"type": "readback", "in": ["x"]}})j");
    EXPECT_EQ(d.code, "W123");
    EXPECT_NE(d.message.find("repeat is empty"), std::string::npos) << d.message;
}

TEST_F(ResolveRepeat, OneFaultIsReportedOnce) {
    const Diagnostic range = bad(pyramid(R"j({"i": "0..9"})j", "x.mip(i+20)"));
    EXPECT_EQ(range.code, "W105");
    const Diagnostic name = bad(pyramid(R"j({"i": "1..9"})j", "x.mip(ii-1)"));
    EXPECT_EQ(name.code, "W107");
    expect_help(name, "did you mean \"i\"");
    const Diagnostic pin = bad(pyramid(R"j({"i": "1..9"})j", "x@dwn.mip(i-1)"));
    EXPECT_EQ(pin.code, "W104");
    expect_help(pin, "did you mean \"down\"");
    const Diagnostic order = bad(R"j("resources": {"x": {"format": "rgba16f", "layers": 4}}, "passes": {
      "a": {"type": "compute", "shader": "make.comp", "repeat": {"i": "0..3"}, "out": {"dst": "x.layer(i)"}},
      "b": {"type": "compute", "shader": "make.comp", "repeat": {"i": "0..3"}, "out": {"dst": "x.layer(i)"}}})j");
    EXPECT_EQ(order.code, "W111");
    expect_help(order, R"j(add "after": ["a"] to "b")j");
}

TEST_F(ResolveRepeat, RangesAreWholeAndBounded) {
    const Diagnostic half = bad(pyramid(R"j({"i": "1..3 / 2"})j"));
    EXPECT_EQ(half.code, "W109");
    expect_help(half, "floor");
    EXPECT_EQ(bad(pyramid(R"j({"i": "1..output"})j")).code, "W106");
    EXPECT_EQ(bad(pyramid(R"j({"i": "1..3 by 0"})j")).code, "W109");
    EXPECT_EQ(bad(pyramid(R"j({"i": "0..99999"})j")).code, "W125");
    EXPECT_EQ(bad(pyramid(R"j({"i": "0..mip(x)"})j")).code, "W106");
}

TEST_F(ResolveRepeat, AnIndexHidesNothing) {
    const Diagnostic d = bad(R"j("consts": {"i": 4}, )j" + pyramid());
    EXPECT_EQ(d.code, "W109");
    EXPECT_NE(d.message.find("already a constant"), std::string::npos) << d.message;
}

}  // namespace
}  // namespace weft::test

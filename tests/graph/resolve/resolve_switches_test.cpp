// Tests how resolve() treats passes with "switch": which versions readers see, in which combinations ports
// are bound, and the variants of passes.
#include "tests/graph/resolve/resolve_fixture.h"
#include "tests/graph/samples/random_switches.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

class ResolveSwitches : public ResolveTest {
 protected:
    ResolveSwitches() { shaders = switch_shaders(); }

    // Returns the keys of a graph with the passes, the parameters "a" to "e", and the images "x", "y", "z",
    // "kept" and "old". The pass "base" writes "x". The output is imported if a pass names it.
    static std::string graph_with(const std::string& body, const std::string& more = "") {
        const bool has_output = body.find("backbuffer") != std::string::npos;
        return R"("params": {"a": true, "b": true, "c": true, "d": true, "e": true},)" +
               std::string(has_output ? R"("imports": {"backbuffer": "output"},)" : "") + R"(
            "resources": {"x": {"format": "rgba16f", "size": 64}, "y": {"format": "rgba16f", "size": 32},
                "z": {"format": "rgba16f", "size": 64}, "kept": {"format": "rgba16f", "size": 64, "keep": true},
                "old": {"format": "rgba16f", "size": 64, "history": 1})" +
               more + R"(}, "passes": {
            "base": {"type": "compute", "shader": "s0.comp", "out": {"dst": "x"}},
            "see": {"type": "readback", "in": ["z"]},)" +
               body + "}";
    }
    static std::string reader(const std::string& b, const std::string& shader = "v2.comp",
                              const std::string& more = "") {
        return R"("read": {"type": "compute", "shader": ")" + shader + R"(", "in": {"a": "x", "b": )" + b +
               R"(}, "out": {"dst": "z"})" + more + "}";
    }
    static const UseDecl& use_of(const PassDecl& pass, const std::string& port, size_t which = 0) {
        static const UseDecl none;
        for (const UseDecl& use : pass.uses)
            if (use.port == port && which-- == 0) return use;
        ADD_FAILURE() << "no port " << port;
        return none;
    }
    static bool has_help(const Diagnostic& d, const std::string& text) {
        return std::ranges::any_of(d.help,
                                   [&](const std::string& h) { return h.find(text) != std::string::npos; });
    }
};

constexpr CombinationSet kAOn = 0xAAAA;  // The combinations in which the first switch is on.
constexpr CombinationSet kBOn = 0xCCCC;  // The same for the second switch.

constexpr const char* kMakeY =
    R"("make": {"type": "compute", "shader": "s0.comp", "out": {"dst": "y"}, "switch": "a"},)";

TEST_F(ResolveSwitches, APassKnowsItsSwitch) {
    const ResolvedGraph graph = good(
        graph_with(R"("make": {"type": "compute", "shader": "s0.comp", "out": {"dst": "kept"}, "switch": "b"},
            "change": {"type": "compute", "shader": "change.comp", "out": {"dst": "x"}, "switch": "!a"},)" +
                   reader("\"kept\"")));
    ASSERT_EQ(graph.switches.size(), 2u);
    EXPECT_EQ(graph.switches[0].param, "a");
    EXPECT_EQ(graph.switches[1].param, "b");
    EXPECT_EQ(pass_in(graph, "make").switch_id, 1u);
    EXPECT_EQ(pass_in(graph, "make").runs_in, kBOn);
    EXPECT_EQ(pass_in(graph, "change").runs_in, complement(kAOn));
    EXPECT_EQ(pass_in(graph, "base").switch_id, kNoId);
    EXPECT_EQ(pass_in(graph, "base").runs_in, kEveryCombination);
    EXPECT_EQ(switches_of(graph), 3u);
}

TEST_F(ResolveSwitches, AnInPlacePassHandsOnTheVersionBefore) {
    const ResolvedGraph graph = good(graph_with(
        R"("change": {"type": "compute", "shader": "change.comp", "out": {"dst": "x"}, "switch": "a"},)" +
        reader("\"x\"", "s2.comp")));
    const UseDecl& write = use_of(pass_in(graph, "change"), "dst");
    ASSERT_EQ(write.passes_on.size(), 1u);
    EXPECT_EQ(write.passes_on[0].producer, find_pass(graph, "base"));
    EXPECT_TRUE(pass_in(graph, "read").variants.empty());
}

TEST_F(ResolveSwitches, AnOverwriteKeepsTheVersionBeforeAlive) {
    const ResolvedGraph graph = good(graph_with(
        R"("over": {"type": "fullscreen", "shader": "s1.frag", "in": {"a": "kept"}, "out": {"dst": "x"}, "switch": "a"},
           "fill": {"type": "clear", "clear": 1, "out": ["kept"]},)" +
        reader("\"x\"", "s2.comp")));
    EXPECT_EQ(use_of(pass_in(graph, "over"), "dst").passes_on.front().producer, find_pass(graph, "base"));
    const FramePlan plan = compile(graph, content_needs(graph), {});
    EXPECT_EQ(plan.live.live_passes[find_pass(graph, "base")], 1) << "its content is seen while over is off";
}

TEST_F(ResolveSwitches, AReplacedInputHasOneUseForEachReference) {
    const ResolvedGraph graph = good(graph_with(kMakeY + reader(R"({"ref": "y", "else": "x"})", "v2.comp")));
    const PassDecl& read = pass_in(graph, "read");
    EXPECT_EQ(use_of(read, "b", 0).resource, find_resource(graph, "y"));
    EXPECT_EQ(use_of(read, "b", 0).used_in, kAOn);
    EXPECT_EQ(use_of(read, "b", 1).resource, find_resource(graph, "x"));
    EXPECT_EQ(use_of(read, "b", 1).used_in, complement(kAOn));
    ASSERT_EQ(read.variants.size(), 2u);
    EXPECT_EQ(read.variants[0].combinations, kAOn);
    EXPECT_EQ(pass_of_variant(read, 1).uses[1].access, Access::none);
    EXPECT_EQ(variant_in(read, 0), 1u);
    EXPECT_EQ(variant_in(read, 1), 0u);
}

TEST_F(ResolveSwitches, AnOptionalInputSetsItsConstantAndItsSize) {
    const ResolvedGraph graph =
        good(graph_with(kMakeY + reader(R"({"ref": "y", "optional": true})", "o2.comp")));
    const PassDecl& read = pass_in(graph, "read");
    ASSERT_EQ(read.variants.size(), 2u);
    EXPECT_EQ(read.variants[0].spec_values.front().bits, 1u);
    EXPECT_EQ(read.variants[0].params.front().value[0], 32);
    EXPECT_EQ(read.variants[1].spec_values.front().bits, 0u);
    EXPECT_EQ(read.variants[1].params.front().value[0], 0);
}

TEST_F(ResolveSwitches, KeptContentIsNotValidWhileItsPassIsOff) {
    const ResolvedGraph graph = good(graph_with(
        R"("make": {"type": "compute", "shader": "s0.comp", "out": {"dst": "kept"}, "switch": "a"},)" +
        reader("\"kept\"")));
    const PassDecl& read = pass_in(graph, "read");
    ASSERT_EQ(read.variants.size(), 2u);
    EXPECT_EQ(read.variants[0].params.front().value[0], 1);
    EXPECT_EQ(read.variants[1].params.front().value[0], 0);
    EXPECT_EQ(use_of(pass_in(graph, "make"), "dst").passes_on.front().producer, kNoId);
}

TEST_F(ResolveSwitches, OnlyAShaderThatAsksForValidityHasVariants) {
    const ResolvedGraph graph = good(graph_with(
        R"("make": {"type": "compute", "shader": "s0.comp", "out": {"dst": "kept"}, "switch": "a"},)" +
        reader("\"kept\"", "s2.comp")));
    EXPECT_TRUE(pass_in(graph, "read").variants.empty());
}

TEST_F(ResolveSwitches, PassesWithOneSwitchNeedNoReplacement) {
    const ResolvedGraph graph =
        good(graph_with(kMakeY + reader(R"("y")", "s2.comp", R"(, "switch": "a", "after": ["fill"])") +
                        R"(, "fill": {"type": "clear", "clear": 0, "out": ["z"]})"));
    EXPECT_EQ(use_of(pass_in(graph, "read"), "b").used_in, kEveryCombination);
    EXPECT_TRUE(pass_in(graph, "read").variants.empty());
}

TEST_F(ResolveSwitches, OppositePassesTogetherAlwaysWrite) {
    const ResolvedGraph graph = good(graph_with(
        kMakeY + std::string(R"("other": {"type": "fullscreen", "shader": "s1.frag", "in": {"a": "x"},
            "out": {"dst": "y"}, "switch": "!a", "after": ["make"]},)") +
        reader("\"y\"")));
    EXPECT_TRUE(pass_in(graph, "read").variants.empty());
}

TEST_F(ResolveSwitches, AReadThatMayFindNothingIsAnError) {
    const Diagnostic error = bad(graph_with(kMakeY + reader("\"y\"", "s2.comp")));
    EXPECT_EQ(error.code, "W234");
    EXPECT_NE(error.message.find("\"a\" is off"), std::string::npos) << error.message;
    EXPECT_TRUE(has_help(error, "\"else\""));
    EXPECT_TRUE(has_help(error, "\"keep\": true"));
    EXPECT_TRUE(has_help(error, "same \"switch\""));
}

TEST_F(ResolveSwitches, AReplacementMustAlwaysExistToo) {
    const Diagnostic error = bad(graph_with(
        kMakeY +
            std::string(
                R"("more": {"type": "compute", "shader": "s0.comp", "out": {"dst": "kept2"}, "switch": "b"},)") +
            reader(R"({"ref": "y", "else": "kept2"})"),
        R"(, "kept2": {"format": "rgba16f", "size": 64})"));
    EXPECT_EQ(error.code, "W234");
    EXPECT_NE(error.message.find("\"a\" is off and \"b\" is off"), std::string::npos) << error.message;
}

TEST_F(ResolveSwitches, ModifyingWhatMayNotExistIsAnError) {
    const Diagnostic error = bad(graph_with(
        kMakeY +
        std::string(
            R"("again": {"type": "compute", "shader": "change.comp", "out": {"dst": "y"}, "after": ["make"]},)") +
        reader(R"({"ref": "y", "else": "x"})")));
    EXPECT_EQ(error.code, "W234");
    EXPECT_NE(error.message.find("\"again\" modifies"), std::string::npos) << error.message;
}

TEST_F(ResolveSwitches, HistoryNeedsAPassThatAlwaysWrites) {
    const Diagnostic error = bad(graph_with(
        R"("make": {"type": "compute", "shader": "s0.comp", "out": {"dst": "old"}, "switch": "a"},)" +
        reader("\"old[-1]\"")));
    EXPECT_EQ(error.code, "W234");
    EXPECT_NE(error.message.find("has history"), std::string::npos) << error.message;
}

TEST_F(ResolveSwitches, TheOutputNeedsAPassThatAlwaysWrites) {
    shaders["picture.frag"] = fragment({"color"});
    const std::string show =
        R"("show": {"type": "fullscreen", "shader": "picture.frag", "out": {"color": "backbuffer"}, "switch": "a"})";
    const Diagnostic error = bad(graph_with(reader("\"x\"", "s2.comp") + "," + show));
    EXPECT_EQ(error.code, "W234");
    (void)good(graph_with(reader("\"x\"", "s2.comp") + "," + show +
                          R"(, "clean": {"type": "clear", "clear": 0, "out": ["backbuffer"]})"));
}

TEST_F(ResolveSwitches, PassesWithoutShaderCannotDependOnSwitches) {
    const Diagnostic error = bad(graph_with(
        kMakeY +
            std::string(
                R"("copy": {"type": "copy", "in": {"src": {"ref": "y", "else": "half"}}, "out": {"dst": "copied"}},
            "fill": {"type": "clear", "clear": 0, "out": ["half"]},
            "deliver": {"type": "readback", "in": ["copied"]},)") +
            reader("\"x\"", "s2.comp"),
        R"(, "half": {"format": "rgba16f", "size": 32}, "copied": {"format": "rgba16f", "size": 32})"));
    EXPECT_EQ(error.code, "W235");
}

TEST_F(ResolveSwitches, AtMostFourSwitches) {
    std::string text;
    std::string last = "base";
    for (const char* name : {"a", "b", "c", "d", "e"}) {
        text += std::string("\"change_") + name +
                R"(": {"type": "compute", "shader": "change.comp", "out": {"dst": "x"},
            "switch": ")" +
                name + R"(", "after": [")" + last + "\"]},";
        last = std::string("change_") + name;
    }
    const Diagnostic error = bad(graph_with(text + reader("\"x\"", "s2.comp")));
    EXPECT_EQ(error.code, "W233");
}

TEST_F(ResolveSwitches, OtherKeysThatSkipFramesAreExcluded) {
    for (const std::string key :
         {R"("rest": true)", R"("repeat": {"i": "0..1"}, "partial": true, "perFrame": 1)"}) {
        const Diagnostic error = bad(graph_with(
            R"("make": {"type": "compute", "shader": "s0.comp", "out": {"dst": "kept"}, "switch": "a", )" +
            key + "}," + reader("\"kept\"", "s2.comp")));
        EXPECT_EQ(error.code, "W235") << key;
    }
    const Diagnostic unknown = bad(graph_with(
        R"("make": {"type": "compute", "shader": "s0.comp", "out": {"dst": "kept"}, "switch": "z"},)" +
        reader("\"kept\"", "s2.comp")));
    EXPECT_EQ(unknown.code, "W233");
}

TEST_F(ResolveSwitches, ASwitchIsLiveUnlessItAlsoChangesTheGraph) {
    const std::string make =
        R"("make": {"type": "compute", "shader": "s0.comp", "out": {"dst": "kept"}, "switch": "a"},)";
    const auto cost = [](const ResolvedGraph& graph, const char* name) {
        return std::ranges::find(graph.params, name, &GraphParam::name)->cost;
    };
    EXPECT_EQ(cost(good(graph_with(make + reader("\"kept\"", "s2.comp"))), "a"), ParamCost::live);
    EXPECT_EQ(cost(good(graph_with(make + reader("\"kept\"", "s2.comp", R"(, "if": "a")"))), "a"),
              ParamCost::graph);
}

TEST_F(ResolveSwitches, AnObserverLooksOnlyWhileTheResourceExists) {
    observed = {"y", "kept"};
    const ResolvedGraph graph = good(graph_with(
        kMakeY +
        std::string(
            R"("keep": {"type": "compute", "shader": "s0.comp", "out": {"dst": "kept"}, "switch": "a"},)") +
        reader(R"({"ref": "y", "else": "x"})")));
    EXPECT_EQ(pass_in(graph, "observe:y").runs_in, kAOn);
    EXPECT_EQ(pass_in(graph, "observe:kept").runs_in, kEveryCombination);
}

TEST_F(ResolveSwitches, APassWithASwitchSharesNoRenderingScope) {
    shaders["picture.frag"] = fragment({"color"});
    const auto scopes = [&](const std::string& key) {
        const ResolvedGraph graph = good(graph_with(
            R"("clean": {"type": "clear", "clear": 0, "out": ["backbuffer"]},
               "first": {"type": "fullscreen", "shader": "picture.frag", "out": {"color": "backbuffer"}, "after": ["clean"],
                         "state": {"blend": "add"}},
               "second": {"type": "fullscreen", "shader": "picture.frag", "out": {"color": "backbuffer"}, "after": ["first"],
                         "state": {"blend": "add"})" +
            key + "}," + reader("\"x\"", "s2.comp", R"(, "after": ["second"])")));
        const FramePlan plan = compile(graph, content_needs(graph), {});
        return plan.barriers.steps[plan.schedule.position[find_pass(graph, "second")]].merges_render_pass;
    };
    EXPECT_TRUE(scopes(""));
    EXPECT_FALSE(scopes(R"(, "switch": "a")"));
}

}  // namespace
}  // namespace weft::test

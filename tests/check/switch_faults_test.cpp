// Plants faults about switches in correct plans. The checker must find each of them.
#include <algorithm>

#include "tests/graph/resolve/resolve_fixture.h"
#include "tests/graph/samples/random_switches.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

class SwitchFaults : public ResolveTest {
 protected:
    SwitchFaults() {
        shaders = switch_shaders();
        shaders["picture.frag"] = fragment({"color"});
        const ResolvedGraph graph =
            good(R"("params": {"a": true, "b": true}, "imports": {"backbuffer": "output"},
            "resources": {"x": {"format": "rgba16f", "size": 64}, "y": {"format": "rgba16f", "size": 64},
                "z": {"format": "rgba16f", "size": 64}},
            "passes": {
                "base": {"type": "fullscreen", "shader": "s0.frag", "out": {"dst": "x"}},
                "change": {"type": "fullscreen", "shader": "s0.frag", "out": {"dst": "x"}, "after": ["base"], "switch": "a"},
                "make": {"type": "compute", "shader": "s0.comp", "out": {"dst": "y"}, "switch": "b"},
                "read": {"type": "compute", "shader": "v2.comp", "in": {"a": "x", "b": {"ref": "y", "else": "x"}},
                         "out": {"dst": "z"}},
                "clean": {"type": "clear", "clear": 0, "out": ["backbuffer"]},
                "show": {"type": "fullscreen", "shader": "picture.frag", "out": {"color": "backbuffer"},
                         "after": ["clean"], "switch": "a"},
                "see": {"type": "readback", "in": ["z"]}})");
        plan_ = compile(graph, content_needs(graph), {});
        EXPECT_TRUE(check_plan(plan_).empty()) << to_text(check_plan(plan_));
    }

    PassDecl& pass(const char* name) { return plan_.graph.passes[find_pass(plan_.graph, name)]; }
    PassStep& step(const char* name) {
        return plan_.barriers.steps[plan_.schedule.position[find_pass(plan_.graph, name)]];
    }
    // Expects that the checker reports an error with this code.
    void expect_fault(const char* code) {
        const Diagnostics faults = check_plan(plan_);
        EXPECT_TRUE(std::ranges::any_of(faults, [&](const Diagnostic& d) { return d.code == code; }))
            << to_text(faults);
    }

    FramePlan plan_;
};

TEST_F(SwitchFaults, ContentThatIsNotStoredForTheFramesWithoutThePass) {
    for (AttachmentOps& ops : step("base").attachments) ops.store = StoreOp::dont_care;
    expect_fault("C349");
}

TEST_F(SwitchFaults, AVersionThatIsNotHandedOn) {
    for (UseDecl& use : pass("change").uses) use.passes_on.clear();
    expect_fault("C349");
}

TEST_F(SwitchFaults, AnInputThatIsReadWhileItsPassIsOff) {
    PassDecl& read = pass("read");
    read.uses[1].used_in = kEveryCombination;
    read.uses.erase(read.uses.begin() + 2);
    read.variants.clear();
    expect_fault("C349");
}

TEST_F(SwitchFaults, TwoResourcesForOnePort) {
    for (UseDecl& use : pass("read").uses)
        use.used_in = use.port == "b" ? CombinationSet{0xCCCC} : use.used_in;
    expect_fault("C349");
}

TEST_F(SwitchFaults, AMissingVariant) {
    pass("read").variants.pop_back();
    expect_fault("C349");
}

TEST_F(SwitchFaults, AVariantForDifferentInputs) {
    pass("read").variants[0].combinations = kEveryCombination;
    pass("read").variants.pop_back();
    expect_fault("C349");
}

TEST_F(SwitchFaults, APassThatRunsInOtherFramesThanItsSwitchSays) {
    pass("change").runs_in = 0x8888;
    expect_fault("C349");
}

TEST_F(SwitchFaults, AnOutputThatNoPassWritesInSomeFrames) {
    // Without "clean", the output is undefined while "show" is off.
    PassDecl& clean = pass("clean");
    clean.switch_id = pass("show").switch_id;
    clean.runs_in = pass("show").runs_in;
    expect_fault("C349");
}

TEST_F(SwitchFaults, ABarrierThatDiscardsTheVersionBefore) {
    for (BarrierDecl& barrier : step("change").barriers) barrier.src.layout = Layout::undefined;
    if (step("change").barriers.empty()) GTEST_FAIL() << "the pass has no barrier";
    expect_fault("C349");
}

}  // namespace
}  // namespace weft::test

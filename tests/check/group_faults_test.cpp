// Each test breaks a correct plan with a group in one way. The checker must report the error C335.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/graph/resolve/resolve_fixture.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

const char* const kGroupGraph = R"j("imports": {"backbuffer": "output"},
 "resources": {"k": "rgba16f", "probes": {"format": "rgba16f", "layers": 3, "keep": true}, "t": "rgba16f"},
 "groups": {"g": {"repeat": {"i": "0..2"}, "resources": {"raw": "rgba16f"}, "passes": {
  "make":  {"type": "compute", "shader": "filter.comp", "in": {"src": "k"}, "out": {"dst": "raw"}},
  "store": {"type": "compute", "shader": "filter.comp", "in": {"src": "raw"}, "out": {"dst": "probes.layer(i)"}}}}},
 "passes": {
  "sky":   {"type": "compute", "shader": "make.comp", "out": {"dst": "k"}},
  "other": {"type": "compute", "shader": "make.comp", "out": {"dst": "t"}},
  "show":  {"type": "fullscreen", "shader": "show.frag", "in": {"src": "t", "all": "probes"},
            "out": ["backbuffer"]}})j";

class GroupFault : public ResolveTest {
 protected:
    GroupFault() {
        shaders["make.comp"] = compute({image_out("dst")});
        shaders["filter.comp"] = compute({sampled("src"), image_out("dst")});
        ShaderBinding all = sampled("all");
        all.arrayed = true;
        shaders["show.frag"] = fragment({"backbuffer"}, {sampled("src"), all});
        plan = compile(good(kGroupGraph), content_needs(good(kGroupGraph)), {});
    }
    void SetUp() override { ASSERT_TRUE(check_plan(plan).empty()) << to_text(check_plan(plan)); }

    [[nodiscard]] Position at(const char* name) const {
        return plan.schedule.position[find_pass(plan.graph, name)];
    }
    PassDecl& pass(const char* name) { return plan.graph.passes[find_pass(plan.graph, name)]; }
    PassStep& step(const char* name) { return plan.barriers.steps[at(name)]; }
    BarrierDecl& own_barrier(std::vector<BarrierDecl>& barriers) {
        const auto found = std::ranges::find_if(barriers, &BarrierDecl::if_pass_runs);
        EXPECT_NE(found, barriers.end());
        return *found;
    }
    // Moves the pass in the schedule to the place directly before or after another pass.
    void move(const char* name, Position to) {
        const Position from = at(name);
        const auto rotate = [&](auto& items) {
            if (from < to)
                std::rotate(items.begin() + from, items.begin() + from + 1, items.begin() + to + 1);
            else
                std::rotate(items.begin() + to, items.begin() + from, items.begin() + from + 1);
        };
        rotate(plan.schedule.order);
        rotate(plan.barriers.steps);
        for (Position p(0); p < plan.schedule.order.size(); p = Position(p + 1))
            plan.schedule.position[plan.schedule.order[p]] = p;
    }
    // Expects an error C335 whose message contains the text.
    void expect_fault(const std::string& text) const {
        const Diagnostics faults = check_plan(plan);
        EXPECT_TRUE(std::ranges::any_of(faults,
                                        [&](const Diagnostic& d) {
                                            return d.code == "C335" &&
                                                   d.message.find(text) != std::string::npos;
                                        }))
            << text << "\n"
            << to_text(faults);
    }

    FramePlan plan;
};

TEST_F(GroupFault, UnitsThatDoNotExist) {
    plan.graph.groups[0].rounds = 9;
    expect_fault("has more rounds than the plan has units for them");
}

TEST_F(GroupFault, APassBetween) {
    ASSERT_TRUE(at("other") < at("g::make#0") || at("other") > at("g::store#2"));
    move("other", at("g::make#1"));
    expect_fault("has another pass between its passes");
}

TEST_F(GroupFault, RoundsThatAreMixed) {
    move("g::make#1", at("g::store#0"));
    expect_fault("runs passes of one round after the next round has begun");
}

TEST_F(GroupFault, SeveralBatches) {
    ASSERT_EQ(plan.submissions.batches.size(), 1u);
    std::vector<Batch>& batches = plan.submissions.batches;
    Batch second = batches[0];
    const auto middle = static_cast<ptrdiff_t>(uint32_t{at("g::make#1")});
    batches[0].epilogue = false;
    batches[0].positions.resize(static_cast<size_t>(middle));
    second.positions.erase(second.positions.begin(), second.positions.begin() + middle);
    second.waits.clear();
    batches.push_back(second);
    expect_fault("is divided into several batches");
}

TEST_F(GroupFault, ABarrierOfEveryFrameBetweenTheRounds) {
    own_barrier(step("g::store#1").barriers).if_pass_runs = false;
    expect_fault("has a barrier at pass \"g::store#1\" that is recorded in every frame");
}

TEST_F(GroupFault, ABarrierOfEveryFrameAfterAPassOfARound) {
    own_barrier(step("g::make#1").after).if_pass_runs = false;
    expect_fault("has a barrier at pass \"g::make#1\" that is recorded in every frame");
}

TEST_F(GroupFault, AWriteThatWaitsForNoOtherRound) {
    std::erase_if(step("g::make#1").barriers, &BarrierDecl::if_pass_runs);
    expect_fault("writes \"g::raw\".mip(0).layer(0) in pass \"g::make#1\"");
}

TEST_F(GroupFault, AWriteThatWaitsForTooFewStages) {
    own_barrier(step("g::make#1").barriers).src.stages = stage::kNone;
    expect_fault("writes \"g::raw\".mip(0).layer(0) in pass \"g::make#1\"");
}

TEST_F(GroupFault, AWriteThatNoReaderWaitsFor) {
    step("g::make#1").after.clear();
    expect_fault(
        "Other rounds access the same part, and the barriers of this pass do not order all of these "
        "accesses before or after the write");
}

TEST_F(GroupFault, AWriteThatIsNotVisibleToAReader) {
    own_barrier(step("g::make#1").after).dst.access = access::kNone;
    expect_fault("writes \"g::raw\".mip(0).layer(0) in pass \"g::make#1\"");
}

TEST_F(GroupFault, AWriteOfAPartThatABarrierLeavesOut) {
    own_barrier(step("g::store#1").after).range.layer = 0;
    expect_fault("writes \"probes\".mip(0).layer(1) in pass \"g::store#1\"");
}

TEST_F(GroupFault, ALatestReadOfWhatNoGroupWrites) {
    for (UseDecl& use : pass("show").uses)
        if (use.port == "src") use.latest = true;
    expect_fault("but no group writes this resource");
}

}  // namespace
}  // namespace weft::test

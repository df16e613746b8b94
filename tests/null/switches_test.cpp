// Tests plans with live switches. Whichever passes are switched off in a frame, and in whichever order the
// null executor runs the commands, the result must be that of the reference run, which keeps every version
// apart.
#include <gtest/gtest.h>

#include <iostream>
#include <random>

#include "null/null_executor.h"
#include "tests/graph/resolve/resolve_fixture.h"
#include "tests/graph/samples/random_switches.h"
#include "tests/null/mutant_judge.h"
#include "tests/null/profile_plans.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

class Switches : public ResolveTest {
 protected:
    Switches() { shaders = switch_shaders(); }

    static FramePlan plan_of(const ResolvedGraph& graph, uint32_t queues) {
        DeviceProfile device;
        device.queue_families = {{QueueKind::graphics, 1}, {QueueKind::compute, 2}, {QueueKind::transfer, 1}};
        CompileOptions options;
        options.queues = logical_queues(device, queues);
        return compile(graph, content_needs(graph), options);
    }

    // Returns true if the two runs have the same defined values in a frame.
    static bool expect_reference(const FramePlan& plan, const SwitchChoice& switches, uint64_t seed,
                                 NullOrder order) {
        const auto frames = static_cast<uint32_t>(switches.size());
        const NullRun wanted = run_reference(plan.graph, plan.live, frames, {}, {}, {}, switches);
        for (const ObservedCell& cell : wanted.observed)
            EXPECT_NE(cell.value, kUndefinedValue) << plan.graph.resources[cell.resource].name;
        NullOptions options{.frames = frames, .seed = seed, .order = order, .switches = switches};
        const NullRun found = run_null(plan, options);
        const std::vector<std::string> different = differences(plan.graph, wanted, found);
        EXPECT_TRUE(different.empty()) << different.front() << "\n"
                                       << (found.faults.empty() ? "" : found.faults.front());
        return different.empty();
    }
};

TEST_F(Switches, EveryCombinationGivesWhatTheReferenceGives) {
    const uint32_t seeds = extended() ? 1500 : 100;
    uint32_t graphs = 0, runs = 0, variants = 0, switched = 0, most = 0;
    for (uint32_t seed = 1; seed <= seeds; ++seed) {
        const RandomSwitches made = random_switches(seed);
        SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + made.text);
        const FramePlan plan = plan_of(good(made.text), 1 + seed % 3);
        if (HasFailure()) return;
        const Diagnostics faults = check_plan(plan);
        ASSERT_TRUE(faults.empty()) << to_text(faults);
        std::mt19937 random(seed);
        const auto count = static_cast<uint32_t>(plan.graph.switches.size());
        for (Combination on = 0; on < 1u << count; ++on) {
            const auto any = [&] { return static_cast<Combination>(random() % kCombinationCount); };
            const SwitchChoice switches{on, on, any(), on, any()};
            if (!expect_reference(plan, switches, seed + on,
                                  on % 3 == 0 ? NullOrder::delayed : NullOrder::shuffled))
                return;
            ++runs;
        }
        ++graphs;
        most = std::max(most, count);
        for (const PassId pass : plan.schedule.order) {
            variants += plan.graph.passes[pass].variants.size() > 1 ? 1 : 0;
            switched += plan.graph.passes[pass].switch_id != kNoId ? 1 : 0;
        }
    }
    std::cout << "seeds 1.." << seeds << ": " << graphs << " graphs, " << switched
              << " passes with a switch, " << variants << " passes with variants, at most " << most
              << " switches; " << runs << " runs\n";
    EXPECT_EQ(most, kMostSwitches);
    EXPECT_GE(switched, 2 * graphs);
    EXPECT_GE(variants, graphs);
}

TEST_F(Switches, ThePlanIsTheSameWhateverTheValues) {
    for (uint32_t seed = 1; seed <= 30; ++seed) {
        const RandomSwitches made = random_switches(seed);
        SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + made.text);
        params.clear();
        const FramePlan on = plan_of(good(made.text), 1 + seed % 3);
        for (uint32_t s = 0; s < made.switches; ++s) params["s" + std::to_string(s)] = 0;
        FramePlan off = plan_of(good(made.text), 1 + seed % 3);
        EXPECT_EQ(switches_of(on.graph), (1u << on.graph.switches.size()) - 1);
        EXPECT_EQ(switches_of(off.graph), 0u);
        for (GraphParam& param : off.graph.params) param.value = 1;
        EXPECT_EQ(plan_hash(on), plan_hash(off));
    }
}

TEST_F(Switches, WhatTheNullExecutorBreaksTheCheckerCatches) {
    const uint32_t seeds = extended() ? 300 : 5;
    Tallies tallies{};
    for (uint32_t seed = 1; seed <= seeds; ++seed) {
        const RandomSwitches made = random_switches(seed + 5000);
        SCOPED_TRACE("seed " + std::to_string(seed + 5000) + "\n" + made.text);
        judge_mutants(plan_of(good(made.text), 1 + seed % 3), extended() ? 4 : 8, tallies);
    }
    print(tallies);
}

}  // namespace
}  // namespace weft::test

// Tests plans with groups. In each frame, any of the rounds may run, in any order. Whichever rounds run, and
// in whichever order the null executor runs the commands, the result must be that of the reference run, which
// keeps every copy apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <random>

#include "graph/rest/frame_steps.h"
#include "graph/rest/rest_state.h"
#include "null/null_executor.h"
#include "null/recorded_steps.h"
#include "tests/graph/resolve/resolve_fixture.h"
#include "tests/graph/samples/random_groups.h"
#include "tests/null/mutant_judge.h"
#include "tests/null/profile_plans.h"
#include "tests/null/rest_closure.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

constexpr uint32_t kMostGroupUnits = 8;

class Groups : public ResolveTest {
 protected:
    Groups() {
        shaders = group_shaders();
        ResourceDecl& noise = imports.imports["noise"].resource;
        noise.format = Format::rgba16f;
        noise.import->entry = {stage::kComputeShader, access::kSampledRead, Layout::shader_read_only};
        noise.import->exit = noise.import->entry;
        noise.import->concurrent = true;
    }

    static FramePlan plan_of(const ResolvedGraph& graph, uint32_t queues) {
        CompileOptions options;
        options.queues = logical_queues({}, queues);
        return compile(graph, content_needs(graph), options);
    }

    // Lets the units of a set run, the rounds of groups in a random order.
    static void add_frame(const FramePlan& plan, uint32_t set, std::mt19937& random, NullOptions& options) {
        std::vector<uint8_t>& rests = options.resting.emplace_back(plan.graph.rest_unit_count, 0);
        std::vector<uint32_t>& rounds = options.rounds.emplace_back();
        for (uint32_t unit = 0; unit < rests.size(); ++unit) {
            const bool runs = (set >> unit & 1u) != 0;
            rests[unit] = runs ? 0 : 1;
            const bool is_round = std::ranges::any_of(
                plan.graph.groups, [&](const GroupDecl& group) { return group.has_unit(unit); });
            if (runs && is_round) rounds.insert(rounds.begin() + random() % (rounds.size() + 1), unit);
        }
    }

    static std::string difference(const FramePlan& plan, const NullOptions& options) {
        const NullRun wanted = run_reference(plan.graph, plan.live, options.frames, options.resting,
                                             options.inputs, options.rounds);
        const NullRun found = run_null(plan, options);
        const std::vector<std::string> different = differences(plan.graph, wanted, found);
        if (different.empty()) return {};
        return different.front() + "\n" + (found.faults.empty() ? "" : found.faults.front());
    }
};

TEST_F(Groups, AnyRoundsInAnyOrderGiveWhatTheReferenceGives) {
    const uint32_t seeds = extended() ? 900 : 60;
    uint32_t graphs = 0, units = 0, most = 0, runs = 0;
    for (uint32_t seed = 1; seed <= seeds; ++seed) {
        const RandomGroups made = random_groups(seed);
        SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + made.text);
        observed = made.observed;
        const FramePlan plan = plan_of(good(made.text), 1 + seed % 3);
        if (HasFatalFailure() || plan.graph.rest_unit_count > kMostGroupUnits) continue;
        const Diagnostics faults = check_plan(plan);
        ASSERT_TRUE(faults.empty()) << to_text(faults);
        std::mt19937 random(seed);
        const uint32_t all = (1u << plan.graph.rest_unit_count) - 1;
        for (uint32_t set = 0; set <= all; ++set, ++runs) {
            NullOptions options{.frames = 0, .seed = seed + set};
            options.order = set % 3 == 0 ? NullOrder::delayed : NullOrder::shuffled;
            for (const uint32_t frame : {all, set, static_cast<uint32_t>(random()), set, all}) {
                add_frame(plan, frame, random, options);
                ++options.frames;
            }
            ASSERT_EQ(difference(plan, options), "");
        }
        ++graphs;
        units += plan.graph.rest_unit_count;
        most = std::max(most, plan.graph.rest_unit_count);
    }
    std::cout << "seeds 1.." << seeds << ": " << graphs << " graphs, " << units << " units, at most " << most
              << " in one graph; " << runs << " runs\n";
    EXPECT_GE(graphs * 10, seeds * 6);
}

// The inputs of the units in each frame, as bytes: one number for each pass of the unit.
std::vector<UnitInput> unit_inputs(const FramePlan& plan, const std::vector<uint32_t>& numbers) {
    std::vector<UnitInput> inputs(plan.graph.rest_unit_count, UnitInput(std::in_place));
    for (const PassId pass : plan.schedule.order)
        if (plan.graph.passes[pass].rest_unit != kNoId)
            inputs[plan.graph.passes[pass].rest_unit]->push_back(static_cast<std::byte>(numbers[pass]));
    return inputs;
}

// From frame to frame, the inputs of about one pass of a unit in six change.
InputChoice random_inputs(const FramePlan& plan, uint32_t frames, std::mt19937& random) {
    InputChoice inputs(frames, std::vector<uint32_t>(plan.graph.passes.size()));
    for (uint32_t frame = 0; frame < frames; ++frame)
        for (PassId pass(0); pass < plan.graph.passes.size(); ++pass) {
            const bool changes = plan.graph.passes[pass].rest_unit == kNoId || random() % 6 == 0;
            inputs[frame][pass] = frame > 0 && !changes ? inputs[frame - 1][pass] : random() % 250;
        }
    return inputs;
}

// Adds what RestState chooses for each frame to the options. Returns the number of dropped entries of lists.
uint32_t choose_frames(const FramePlan& plan, const std::vector<TurnLists>& turns, NullOptions& options) {
    RestState state(plan);
    uint32_t dropped = 0;
    for (uint32_t frame = 0; frame < options.frames; ++frame) {
        const std::vector<UnitInput> inputs = unit_inputs(plan, options.inputs[frame]);
        const UnitChoice choice = state.choose(inputs, turns.empty() ? TurnLists{} : turns[frame]);
        std::vector<uint8_t>& rests = options.resting.emplace_back();
        for (const Wake& wake : choice.wakes) rests.push_back(wake.runs() ? 0 : 1);
        options.rounds.push_back(choice.rounds);
        dropped += choice.dropped_turns;
        state.commit(inputs, choice);
    }
    return dropped;
}

// The Vulkan executor and the null executor each have a function that lists what a batch records.
TEST_F(Groups, BothExecutorsRecordTheSameSteps) {
    uint32_t compared = 0;
    for (uint32_t seed = 1; seed <= 40; ++seed) {
        const FramePlan plan = plan_of(good(random_groups(seed + 50000).text), 1 + seed % 3);
        std::mt19937 random(seed);
        NullOptions options{.frames = 1};
        add_frame(plan, static_cast<uint32_t>(random()), random, options);
        std::vector<uint8_t> runs;
        for (const uint8_t rests : options.resting[0]) runs.push_back(rests == 0 ? 1 : 0);
        for (const Batch& batch : plan.submissions.batches) {
            const std::vector<FrameStep> ours = frame_steps(plan, batch, runs, options.rounds[0]);
            const std::vector<null::RecordedStep> theirs =
                null::recorded_steps(plan, batch, 0, options.resting, options.rounds);
            const auto equal = [](const FrameStep& a, const null::RecordedStep& b) {
                return a.position == b.position && a.shared_before == b.shared_before && a.runs == b.runs &&
                       a.shared_after == b.shared_after;
            };
            EXPECT_TRUE(std::ranges::equal(ours, theirs, equal)) << "seed " << seed + 50000;
            ++compared;
        }
    }
    EXPECT_GT(compared, 40u);
}

TEST_F(Groups, RestingRoundsChangeNoResult) {
    const uint32_t seeds = extended() ? 2000 : 60, sequences = extended() ? 20 : 1;
    uint64_t units = 0, ran = 0;
    for (uint32_t seed = 1; seed <= seeds; ++seed) {
        const RandomGroups made = random_groups(seed + 30000, true);
        SCOPED_TRACE("seed " + std::to_string(seed + 30000) + "\n" + made.text);
        const FramePlan plan = plan_of(good(made.text), 1 + seed % 3);
        ASSERT_TRUE(check_plan(plan).empty()) << to_text(check_plan(plan));
        for (uint32_t sequence = 0; sequence < sequences; ++sequence) {
            std::mt19937 random(seed * 100 + sequence);
            NullOptions options{.frames = 6, .seed = seed};
            options.inputs = random_inputs(plan, options.frames, random);
            choose_frames(plan, {}, options);
            ASSERT_EQ(options.resting, rest_closure(plan, options.inputs));
            const NullRun wanted = run_reference(plan.graph, plan.live, options.frames, {}, options.inputs);
            const std::vector<std::string> different =
                differences(plan.graph, wanted, run_null(plan, options));
            ASSERT_TRUE(different.empty()) << different.front();
            for (const std::vector<uint8_t>& frame : options.resting)
                for (const uint8_t rests : frame) units += 1, ran += rests == 0 ? 1 : 0;
        }
    }
    std::cout << "seeds 30001.." << 30000 + seeds << ", " << sequences
              << " sequences of 6 frames each: " << ran << " of " << units << " units ran\n";
    EXPECT_LT(ran * 3, units * 2);
}

// Rounds run as RestState chooses: in turn, with limits and in the order of random lists, some of whose
// entries do not exist or occur twice. The results are those of the reference run with the same rounds.
TEST_F(Groups, TurnsGiveWhatTheReferenceGives) {
    const uint32_t seeds = extended() ? 1000 : 60;
    uint64_t rounds = 0, dropped = 0;
    for (uint32_t seed = 1; seed <= seeds; ++seed) {
        const RandomGroups made = random_groups(seed + 40000);
        SCOPED_TRACE("seed " + std::to_string(seed + 40000) + "\n" + made.text);
        observed = made.observed;
        const FramePlan plan = plan_of(good(made.text), 1 + seed % 3);
        std::mt19937 random(seed);
        NullOptions options{.frames = 8, .seed = seed};
        options.inputs = random_inputs(plan, options.frames, random);
        std::vector<TurnLists> turns(options.frames);
        for (TurnLists& lists : turns)
            for (const std::string& name : made.turns)
                for (uint32_t entry = random() % 5; entry > 0 && random() % 3 > 0; --entry)
                    lists[name].push_back(random() % 5);
        dropped += choose_frames(plan, turns, options);
        for (const std::vector<uint32_t>& frame : options.rounds) rounds += frame.size();
        ASSERT_EQ(difference(plan, options), "");
    }
    std::cout << "seeds 40001.." << 40000 + seeds << ": " << rounds << " rounds ran, " << dropped
              << " entries of lists were dropped\n";
    EXPECT_GT(dropped, 0u);
}

TEST_F(Groups, WhatTheNullExecutorBreaksTheCheckerCatches) {
    const uint32_t seeds = extended() ? 300 : 25;
    Tallies tallies{};
    for (uint32_t seed = 1; seed <= seeds; ++seed) {
        const RandomGroups made = random_groups(seed + 70000);
        SCOPED_TRACE("seed " + std::to_string(seed + 70000) + "\n" + made.text);
        observed = made.observed;
        judge_mutants(plan_of(good(made.text), 1 + seed % 3), extended() ? 4 : 8, tallies);
    }
    print(tallies);
}

}  // namespace
}  // namespace weft::test

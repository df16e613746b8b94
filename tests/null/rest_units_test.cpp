// Tests plans with rest units. Any set of the units may rest in a frame. Whichever units rest, and in
// whichever order the null executor runs the commands, the result must be that of the reference run, which
// keeps every copy apart.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <map>
#include <random>

#include "graph/rest/rest_state.h"
#include "null/null_executor.h"
#include "tests/graph/resolve/resolve_fixture.h"
#include "tests/graph/samples/random_rest.h"
#include "tests/null/mutant_judge.h"
#include "tests/null/profile_plans.h"
#include "tests/null/rest_closure.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

constexpr uint32_t kMostUnits = 8;

std::vector<uint8_t> as_list(uint32_t set, uint32_t units) {
    std::vector<uint8_t> rests(units);
    for (uint32_t unit = 0; unit < units; ++unit) rests[unit] = set >> unit & 1u;
    return rests;
}

class RestUnits : public ResolveTest {
 protected:
    RestUnits() {
        shaders = rest_shaders();
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

    // Compares a run with the reference run. All units run in frame 0.
    static void expect_reference(const FramePlan& plan, const RestChoice& resting, uint64_t seed,
                                 NullOrder order) {
        const auto frames = static_cast<uint32_t>(resting.size());
        const NullRun wanted = run_reference(plan.graph, plan.live, frames, resting);
        const NullRun found = run_null(plan, {frames, seed, order, resting});
        const std::vector<std::string> different = differences(plan.graph, wanted, found);
        ASSERT_TRUE(different.empty()) << different.front() << "\n"
                                       << (found.faults.empty() ? "" : found.faults.front());
    }

    void all_subsets(const FramePlan& plan, uint32_t seed) {
        const uint32_t units = plan.graph.rest_unit_count;
        std::mt19937 random(seed);
        const auto any = [&] { return as_list(static_cast<uint32_t>(random()), units); };
        for (uint32_t set = 0; set < 1u << units; ++set) {
            const RestChoice resting{as_list(0, units), as_list(set, units), any(), as_list(set, units),
                                     any()};
            const NullOrder order = set % 3 == 0 ? NullOrder::delayed : NullOrder::shuffled;
            expect_reference(plan, resting, seed + set, order);
            if (HasFatalFailure()) return;
            ++runs_;
        }
    }

    static constexpr uint32_t kFrames = 6;

    // From frame to frame, the inputs of about one resting pass of six change. The inputs of other passes
    // change in every frame.
    static InputChoice random_inputs(const FramePlan& plan, uint32_t seed) {
        std::mt19937 random(seed);
        InputChoice inputs(kFrames, std::vector<uint32_t>(plan.graph.passes.size()));
        for (uint32_t frame = 0; frame < kFrames; ++frame)
            for (PassId pass(0); pass < plan.graph.passes.size(); ++pass) {
                const bool changes = plan.graph.passes[pass].rest_unit == kNoId || random() % 6 == 0;
                inputs[frame][pass] = frame > 0 && !changes ? inputs[frame - 1][pass] : random() % 1000;
            }
        return inputs;
    }

    // Returns the units that rest, as RestState chooses.
    static RestChoice chosen(const FramePlan& plan, const InputChoice& inputs) {
        RestState state(plan);
        RestChoice resting;
        for (const std::vector<uint32_t>& frame : inputs) {
            std::vector<UnitInput> bytes(plan.graph.rest_unit_count, UnitInput(std::in_place));
            for (const PassId pass : plan.schedule.order) {
                const uint32_t unit = plan.graph.passes[pass].rest_unit;
                if (unit == kNoId) continue;
                for (const std::byte byte : std::as_bytes(std::span(&frame[pass], 1)))
                    bytes[unit]->push_back(byte);
            }
            const UnitChoice choice = state.choose(bytes);
            resting.emplace_back();
            for (const Wake& wake : choice.wakes) resting.back().push_back(wake.runs() ? 0 : 1);
            state.commit(bytes, choice);
        }
        return resting;
    }

    uint64_t runs_ = 0;
};

TEST_F(RestUnits, AnySubsetOfUnitsGivesWhatTheReferenceGives) {
    const uint32_t seeds = extended() ? 700 : 60;
    uint32_t graphs = 0, refused = 0, units = 0, most = 0;
    for (uint32_t seed = 1; seed <= seeds; ++seed) {
        const RandomRest made = random_rest(seed, RestShaders::fake, seed % 2 == 0);
        SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + made.text);
        observed = made.observed;
        const Result<ResolvedGraph> graph = run(made.text);
        if (!graph) {
            ++refused;
            for (const Diagnostic& d : graph.errors()) ASSERT_EQ(d.code, "W150") << to_text(d);
            continue;
        }
        if (graph->rest_unit_count > kMostUnits) continue;
        const FramePlan plan = plan_of(*graph, 1 + seed % 3);
        const Diagnostics faults = check_plan(plan);
        ASSERT_TRUE(faults.empty()) << to_text(faults);
        all_subsets(plan, seed);
        if (HasFatalFailure()) return;
        ++graphs;
        units += graph->rest_unit_count;
        most = std::max(most, graph->rest_unit_count);
    }
    std::cout << "seeds 1.." << seeds << ": " << graphs << " graphs, " << units << " units, at most " << most
              << " in one graph; " << runs_ << " runs; " << refused << " graphs refused\n";
    EXPECT_GE(graphs * 10, seeds * 7);
}

// Units run as RestState chooses, while the inputs of random passes change. The results must be those of a
// run in which all units run in every frame. A second, simpler computation must choose the same units.
TEST_F(RestUnits, ChangesOfInputsGiveWhatRunningEverythingGives) {
    const uint32_t seeds = extended() ? 2000 : 60, sequences = extended() ? 20 : 4;
    uint64_t units = 0, ran = 0;
    for (uint32_t seed = 1; seed <= seeds; ++seed) {
        const RandomRest made = random_rest(seed + 20000);
        observed = made.observed;
        SCOPED_TRACE("seed " + std::to_string(seed + 20000) + "\n" + made.text);
        const FramePlan plan = plan_of(good(made.text), 1 + seed % 3);
        ASSERT_TRUE(check_plan(plan).empty()) << to_text(check_plan(plan));
        for (uint32_t sequence = 0; sequence < sequences; ++sequence) {
            const InputChoice inputs = random_inputs(plan, seed * 100 + sequence);
            const RestChoice resting = chosen(plan, inputs);
            ASSERT_EQ(resting, rest_closure(plan, inputs));
            const NullRun wanted = run_reference(plan.graph, plan.live, kFrames, {}, inputs);
            const NullRun found = run_null(plan, {kFrames, seed, NullOrder::shuffled, resting, inputs});
            const std::vector<std::string> different = differences(plan.graph, wanted, found);
            ASSERT_TRUE(different.empty()) << different.front() << "\n"
                                           << (found.faults.empty() ? "" : found.faults.front());
            for (const std::vector<uint8_t>& frame : resting)
                for (const uint8_t rests : frame) units += 1, ran += rests == 0 ? 1 : 0;
        }
    }
    std::cout << "seeds 20001.." << 20000 + seeds << ", " << sequences << " sequences of " << kFrames
              << " frames each: " << ran << " of " << units << " units ran\n";
    EXPECT_LT(ran * 3, units * 2);
}

TEST_F(RestUnits, WhatTheNullExecutorBreaksTheCheckerCatches) {
    const uint32_t seeds = extended() ? 300 : 25;
    Tallies tallies{};
    for (uint32_t seed = 1; seed <= seeds; ++seed) {
        const RandomRest made = random_rest(seed + 5000, RestShaders::fake, seed % 2 == 0);
        SCOPED_TRACE("seed " + std::to_string(seed + 5000) + "\n" + made.text);
        observed = made.observed;
        const Result<ResolvedGraph> graph = run(made.text);
        if (graph) judge_mutants(plan_of(*graph, 1 + seed % 3), extended() ? 4 : 8, tallies);
    }
    print(tallies);
}

}  // namespace
}  // namespace weft::test

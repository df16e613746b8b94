// Purpose: compares two plans of a random frame on a device. The compiler's plan must give the same bytes as
// a plan without shared memory and with full barriers. The validation layers must give no message.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

#include "tests/graph/compile/naive_plan.h"
#include "tests/graph/samples/random_graph.h"
#include "tests/graph/samples/random_graph_coverage.h"
#include "tests/vulkan/device_fixture.h"
#include "tests/vulkan/plan_runner.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::vk {
namespace {

// All features except multiview, which llvmpipe draws wrongly.
test::RandomGraphOptions single_views() {
    test::RandomGraphOptions options = test::all_features();
    options.views = false;
    return options;
}

constexpr uint32_t kFirstSeed = 1;
constexpr uint32_t kSeeds = 16;

using RandomGraphsVk = DeviceTest;

uint32_t alias_transition_count(const FramePlan& plan) {
    uint32_t count = 0;
    for (const AliasTransition& transition : plan.memory.alias_transitions)
        count += transition.from != transition.to ? 1 : 0;
    return count;
}

// Expects that both plans give the same readbacks and leave the same content in the imported buffers.
void expect_equal(const PlanResult& compiled, const PlanResult& naive) {
    ASSERT_EQ(compiled.readbacks.size(), naive.readbacks.size());
    ASSERT_FALSE(naive.readbacks.empty());
    for (size_t i = 0; i < naive.readbacks.size(); ++i) {
        EXPECT_EQ(compiled.readbacks[i].frame_index, naive.readbacks[i].frame_index);
        EXPECT_FALSE(naive.readbacks[i].bytes.empty());
        EXPECT_TRUE(compiled.readbacks[i].bytes == naive.readbacks[i].bytes)
            << "frame " << i << " differs from the naive run";
    }
    for (const auto& [name, bytes] : naive.imports)
        EXPECT_TRUE(compiled.imports.at(name) == bytes)
            << "import \"" << name << "\" ends differently from the naive run";
}

DeviceProfile three_families() {
    DeviceProfile profile;
    profile.queue_families = {{QueueKind::graphics, 1}, {QueueKind::compute, 2}, {QueueKind::transfer, 1}};
    return profile;
}

// Runs graphs with all features of the graph generator on one to four logical queues. Half of the plans
// assume a device with three queue families. The real device may have fewer: the executor maps each logical
// queue of the plan to a queue of the device. Three frames run, so that the third frame can read a history
// of two frames.
TEST_F(RandomGraphsVk, RunsBitForBitWithAllFeaturesOnSeveralQueues) {
    constexpr uint32_t kFirstQueueSeed = 100;
    const uint32_t seeds = std::getenv("WEFT_EXTENDED") != nullptr ? 200 : 36;
    TestShaders shaders;
    test::GraphCoverage coverage;
    for (uint32_t seed = kFirstQueueSeed; seed < kFirstQueueSeed + seeds; ++seed) {
        const uint32_t queues = 1 + seed / 2 % 4;
        SCOPED_TRACE("seed " + std::to_string(seed) + " on " + std::to_string(queues) + " queues");
        const ResolvedGraph graph = test::random_graph(seed, single_views());
        const MemoryNeeds needs = query_memory_needs(device(), graph);
        CompileOptions options;
        options.queues = logical_queues(seed % 2 == 0 ? DeviceProfile{} : three_families(), queues);
        const FramePlan plan = compile(graph, needs, options);
        const Diagnostics faults = check_plan(plan);
        EXPECT_TRUE(faults.empty()) << to_text(faults);
        coverage.add(plan);
        const RunOptions run{3, {}, seed % 3 == 0};
        expect_equal(run_plan(device(), plan, shaders, run),
                     run_plan(device(), test::naive_plan(graph, needs), shaders, run));
        EXPECT_EQ(device().messages().count(), 0u);
        if (HasFailure()) return;
    }
    std::printf("seeds %u..%u, %s\n", kFirstQueueSeed, kFirstQueueSeed + seeds - 1, coverage.text().c_str());
    EXPECT_GE(coverage.several_queues * 2, seeds);
    EXPECT_GE(coverage.history * 10, seeds * 3);
    EXPECT_GE(coverage.alias_transitions * 2, seeds);
    EXPECT_GE(coverage.arrays * 20, seeds);
}

TEST_F(RandomGraphsVk, RunsBitForBitLikeTheNaivePlan) {
    TestShaders shaders;
    uint32_t shared = 0;
    for (uint32_t seed = kFirstSeed; seed < kFirstSeed + kSeeds; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const ResolvedGraph graph = test::random_graph(seed);
        const MemoryNeeds needs = query_memory_needs(device(), graph);
        const FramePlan plan = compile(graph, needs, {});
        const Diagnostics faults = check_plan(plan);
        EXPECT_TRUE(faults.empty()) << to_text(faults);
        shared += alias_transition_count(plan) != 0 ? 1 : 0;
        const auto start = std::chrono::steady_clock::now();
        expect_equal(run_plan(device(), plan, shaders),
                     run_plan(device(), test::naive_plan(graph, needs), shaders));
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        std::printf("seed %u: %zu of %zu passes, %u hand-overs, %.2f s\n", seed, plan.schedule.order.size(),
                    graph.passes.size(), alias_transition_count(plan), took.count());
        EXPECT_EQ(device().messages().count(), 0u);
        if (HasFailure()) return;
    }
    EXPECT_GE(shared, kSeeds / 2) << "too few plans share memory to prove anything";
}

}  // namespace
}  // namespace weft::vk

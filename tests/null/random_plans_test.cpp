// Random frames give under the compiler's plans, in the worst orders that these allow, what they mean.
#include <gtest/gtest.h>

#include <iostream>

#include "graph/naive_plan.h"
#include "graph/random_graph.h"
#include "null/null_executor.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

constexpr uint32_t kGraphs = 300;
constexpr NullOptions kOrders[] = {{3, 0, NullOrder::recorded},
                                   {3, 1, NullOrder::delayed},
                                   {3, 2, NullOrder::shuffled},
                                   {3, 3, NullOrder::shuffled}};

void expect_reference(const FramePlan& plan) {
    const NullRun wanted = run_reference(plan.graph, plan.live);
    for (const NullOptions& options : kOrders) {
        const NullRun found = run_null(plan, options);
        const std::vector<std::string> different = differences(plan.graph, wanted, found);
        EXPECT_TRUE(different.empty()) << different.front() << "\n"
                                       << (found.faults.empty() ? "" : found.faults.front());
    }
}

std::vector<LogicalQueue> queues_of(uint32_t count, bool one_family) {
    DeviceProfile profile;
    if (!one_family)
        profile.queue_families = {
            {QueueKind::graphics, 1}, {QueueKind::compute, 2}, {QueueKind::transfer, 1}};
    return logical_queues(profile, count);
}

// Deterministic hints: a third of what could go elsewhere asks for each other queue.
ResolvedGraph with_hints(ResolvedGraph graph, uint32_t seed) {
    for (PassId id = 0; id < graph.passes.size(); ++id) {
        const uint32_t turn = (id * 2654435761u ^ seed * 40503u) >> 7;
        graph.passes[id].queue = static_cast<QueueKind>(turn % 3);
    }
    for (ResourceDecl& resource : graph.resources)
        if (resource.import) resource.import->concurrent = true;
    return graph;
}

TEST(RandomPlans, GiveWhatTheGraphMeans) {
    for (uint32_t seed = 0; seed < kGraphs; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const ResolvedGraph graph = random_graph(seed);
        expect_reference(compile(graph, content_needs(graph), {}));
        expect_reference(naive_plan(graph));
        if (HasFailure()) return;
    }
}

TEST(RandomPlans, GiveTheSameOnSeveralQueues) {
    for (uint32_t seed = 0; seed < kGraphs; ++seed) {
        const uint32_t count = 1 + seed % 4;
        SCOPED_TRACE("seed " + std::to_string(seed));
        const ResolvedGraph graph = with_hints(random_graph(seed), seed);
        CompileOptions options;
        options.queues = queues_of(count, seed % 8 == 7);
        expect_reference(compile(graph, content_needs(graph), options));
    }
}

}  // namespace
}  // namespace weft::test

// Random frames give under the compiler's plans, in the worst orders that these allow, what they mean.
#include <gtest/gtest.h>

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

TEST(RandomPlans, GiveWhatTheGraphMeans) {
    for (uint32_t seed = 0; seed < kGraphs; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const ResolvedGraph graph = random_graph(seed);
        expect_reference(compile(graph, content_needs(graph), {}));
        expect_reference(naive_plan(graph));
        if (HasFailure()) return;
    }
}

}  // namespace
}  // namespace weft::test

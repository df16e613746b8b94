// Compares the heap size of plans with the minimum for their pass order. The graphs are those that were used
// to measure other frameworks.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "graph/compile/bench_graph.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

FramePlan planned(const BenchGraph& bench) {
    const ResolvedGraph graph = make_bench_graph(bench);
    CompileOptions options;
    options.keep_all_passes = true;
    options.granularity_bytes = 1;
    return compile(graph, bench_needs(graph), options);
}

double gap(const FramePlan& plan) {
    return static_cast<double>(plan.memory.heap_bytes) / static_cast<double>(plan.memory.peak_live_bytes);
}

// The heap size divided by the peak of live memory must be at most 1.05 on average, and at most 1.10 for each
// graph.
TEST(Packing, StaysNearTheLeastPossible) {
    double sum = 0, worst = 0;
    uint32_t count = 0;
    for (const BenchShape shape : {BenchShape::chain, BenchShape::window32, BenchShape::random}) {
        for (const uint32_t passes : {100u, 1000u}) {
            double shape_sum = 0, shape_worst = 0;
            for (uint32_t seed = 1; seed <= 20; ++seed) {
                const FramePlan plan = planned({passes, shape, seed});
                for (const ScheduleCandidate& candidate : plan.schedule.candidates)
                    EXPECT_LE(plan.memory.peak_live_bytes, candidate.peak_live_bytes);
                shape_sum += gap(plan);
                shape_worst = std::max(shape_worst, gap(plan));
            }
            std::cout << bench_shape_name(shape) << " " << passes << ": heap / peak-live mean "
                      << shape_sum / 20 << ", worst " << shape_worst << "\n";
            sum += shape_sum;
            count += 20;
            worst = std::max(worst, shape_worst);
        }
    }
    EXPECT_LE(sum / count, 1.05);
    EXPECT_LE(worst, 1.10);
}

TEST(Packing, TheReferenceGraphNeedsNoMoreThanItsBestOrder) {
    const FramePlan plan = planned({1000, BenchShape::random, 12345});
    const double mib = static_cast<double>(plan.memory.peak_live_bytes) / 1048576.0;
    std::cout << "random 1000, seed 12345: peak-live " << mib << " MiB, heap / peak-live " << gap(plan)
              << "\n";
    EXPECT_LE(mib, 2355.5);
    const Diagnostics faults = check_plan(planned({100, BenchShape::random, 12345}));
    EXPECT_TRUE(faults.empty()) << to_text(faults);
}

}  // namespace
}  // namespace weft::test

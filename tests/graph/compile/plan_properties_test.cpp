// Tests properties that every plan must have, with many random graphs.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "tests/graph/compile/naive_plan.h"
#include "tests/graph/samples/random_graph.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

constexpr uint32_t kRandomGraphs = 300;

bool hands_over(const FramePlan& plan) {
    return std::any_of(plan.memory.alias_transitions.begin(), plan.memory.alias_transitions.end(),
                       [](const AliasTransition& h) { return h.from != h.to; });
}

bool has_partial_ranges(const FramePlan& plan) {
    for (const PassStep& step : plan.barriers.steps)
        for (const BarrierDecl& b : step.barriers)
            if (b.range != plan.graph.resources[b.resource].whole()) return true;
    return false;
}

bool share_bytes(const Placement& a, const Placement& b) {
    return a.heap == b.heap && a.offset_bytes < b.offset_bytes + b.size_bytes &&
           b.offset_bytes < a.offset_bytes + a.size_bytes;
}

void expect_apart(const FramePlan& plan) {
    const auto live_together = [&](const Placement& a, const Placement& b) {
        const LifetimeSpan &s = plan.lifetimes.spans[a.resource], &t = plan.lifetimes.spans[b.resource];
        return s.first <= t.last && t.first <= s.last;
    };
    for (const Placement& a : plan.memory.placements) {
        EXPECT_LE(a.offset_bytes + a.size_bytes, plan.memory.heaps[a.heap].size_bytes);
        for (const Placement& b : plan.memory.placements)
            EXPECT_FALSE(a.resource < b.resource && live_together(a, b) && share_bytes(a, b))
                << plan.graph.resources[a.resource].name << " and " << plan.graph.resources[b.resource].name;
    }
}

TEST(PlanProperties, RandomFramesCompileApartAndProved) {
    uint32_t aliased = 0, ranged = 0, culled = 0;
    double gap = 0;
    for (uint32_t seed = 0; seed < kRandomGraphs; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const ResolvedGraph graph = random_graph(seed);
        const FramePlan plan = compile(graph, content_needs(graph), {});
        expect_apart(plan);
        const Diagnostics faults = check_plan(plan);
        EXPECT_TRUE(faults.empty()) << to_text(faults);
        aliased += hands_over(plan);
        ranged += has_partial_ranges(plan);
        culled += plan.schedule.order.size() < graph.passes.size();
        gap += static_cast<double>(plan.memory.heap_bytes) / static_cast<double>(plan.memory.peak_live_bytes);
        if (HasFailure()) break;
    }
    std::cout << kRandomGraphs << " graphs (seeds 0.." << kRandomGraphs - 1 << "): " << aliased
              << " hand memory over, " << ranged << " use subresource ranges, " << culled
              << " have culled passes, heap / peak " << gap / kRandomGraphs << "\n";
    EXPECT_GE(aliased, kRandomGraphs / 2);
    EXPECT_GE(ranged, kRandomGraphs * 3 / 10);
    EXPECT_GE(culled, kRandomGraphs * 3 / 10);
    EXPECT_LE(gap / kRandomGraphs, 1.05);
}

TEST(PlanProperties, TheChosenOrderIsTheBestCandidate) {
    for (uint32_t seed = 0; seed < kRandomGraphs; ++seed) {
        const ResolvedGraph graph = random_graph(seed);
        const FramePlan plan = compile(graph, content_needs(graph), {});
        ASSERT_EQ(plan.schedule.candidates.size(), 3u);
        EXPECT_EQ(plan.schedule.candidates.front().name, "program");
        for (const ScheduleCandidate& candidate : plan.schedule.candidates)
            EXPECT_LE(plan.memory.peak_live_bytes, candidate.peak_live_bytes) << "seed " << seed;
    }
}

TEST(PlanProperties, TheSameFrameGivesTheSamePlan) {
    for (uint32_t seed = 0; seed < 30; ++seed) {
        const ResolvedGraph graph = random_graph(seed);
        EXPECT_EQ(plan_hash(compile(graph, content_needs(graph), {})),
                  plan_hash(compile(graph, content_needs(graph), {})));
    }
    const ResolvedGraph one = random_graph(1), two = random_graph(2);
    EXPECT_NE(plan_hash(compile(one, content_needs(one), {})),
              plan_hash(compile(two, content_needs(two), {})));
}

// Removes each barrier before a pass in turn and expects an error from the checker. This shows two things:
// none of these barriers is unnecessary, and the checker notices if one of them is missing.
TEST(PlanProperties, EveryBarrierIsNeeded) {
    for (uint32_t seed = 0; seed < 15; ++seed) {
        const ResolvedGraph graph = random_graph(seed, {5, 25});
        const FramePlan plan = compile(graph, content_needs(graph), {});
        for (Position p(0); p < plan.barriers.steps.size(); ++p) {
            for (size_t i = 0; i < plan.barriers.steps[p].barriers.size(); ++i) {
                FramePlan without = plan;
                std::vector<BarrierDecl>& barriers = without.barriers.steps[p].barriers;
                barriers.erase(barriers.begin() + static_cast<std::ptrdiff_t>(i));
                const BarrierDecl& dropped = plan.barriers.steps[p].barriers[i];
                EXPECT_FALSE(check_plan(without).empty())
                    << "seed " << seed << ": before " << graph.passes[dropped.to].name << " on "
                    << graph.resources[dropped.resource].name;
            }
        }
    }
}

TEST(PlanProperties, TheNaivePlanIsProvedToo) {
    for (uint32_t seed = 0; seed < 50; ++seed) {
        const Diagnostics faults = check_plan(naive_plan(random_graph(seed)));
        EXPECT_TRUE(faults.empty()) << "seed " << seed << "\n" << to_text(faults);
        if (HasFailure()) break;
    }
}

TEST(PlanProperties, SizesStayWithinTheOptions) {
    for (uint32_t seed = 0; seed < kRandomGraphs; ++seed) {
        const size_t passes = random_graph(seed).passes.size();
        EXPECT_GE(passes, 5u) << "seed " << seed;
        EXPECT_LE(passes, 60u) << "seed " << seed;
    }
}

}  // namespace
}  // namespace weft::test

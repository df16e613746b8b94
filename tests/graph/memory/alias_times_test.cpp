// Tests QueueTimes, which says whether the lifetimes of two resources overlap if the frame has several
// queues. Definition: resource a is over before resource b begins if each pass that uses b runs after all
// passes that use a. The vector clocks tell which passes surely run after which.
#include "graph/memory/alias_times.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "tests/graph/samples/random_plan.h"

namespace weft::test {
namespace {

bool over_before(const FramePlan& plan, ResourceId a, ResourceId b) {
    const auto& [first_a, last_a, queues_a] = plan.lifetimes.spans[a];
    const auto& [first_b, last_b, queues_b] = plan.lifetimes.spans[b];
    return std::ranges::all_of(queues_b, [&](const QueueSpan& later) {
        return std::ranges::all_of(queues_a, [&](const QueueSpan& earlier) {
            return plan.schedule.clocks[later.first][earlier.queue] > earlier.last;
        });
    });
}

struct Counts {
    size_t overlapping = 0, in_turn = 0, behind_queues = 0;
};

void check_times(const FramePlan& plan, uint32_t seed, Counts& counts) {
    std::vector<ResourceId> used;
    for (ResourceId id(0); id < plan.graph.resources.size(); ++id)
        if (plan.lifetimes.spans[id].first <= plan.lifetimes.spans[id].last) used.push_back(id);
    const QueueTimes times = QueueOrder(plan.schedule).times(used, plan.lifetimes);
    for (uint32_t a = 0; a < used.size(); ++a) {
        for (uint32_t b = 0; b < used.size(); ++b) {
            const LifetimeSpan &s = plan.lifetimes.spans[used[a]], &t = plan.lifetimes.spans[used[b]];
            if (a == b || s.first > t.first) continue;
            const bool overlap = !over_before(plan, used[a], used[b]);
            EXPECT_EQ(times.may_overlap(a, b), overlap)
                << "seed " << seed << ", " << plan.graph.resources[used[a]].name << " and "
                << plan.graph.resources[used[b]].name;
            ++(overlap ? counts.overlapping : counts.in_turn);
            if (overlap && s.last < t.first) ++counts.behind_queues;
            const uint32_t last = times.last_position(a);
            EXPECT_TRUE(!overlap || t.first <= std::max<uint32_t>(s.last, last)) << "seed " << seed;
        }
    }
}

TEST(QueueTimes, ResourcesOverlapUnlessTheClocksProveThatOneIsOver) {
    Counts counts;
    for (uint32_t seed = 1; seed <= 200; ++seed) {
        const FramePlan plan = random_plan(seed, 40);
        if (plan.schedule.queues.size() > 1) check_times(plan, seed, counts);
    }
    std::printf("%zu pairs overlap, %zu of them only because of several queues; %zu do not\n",
                counts.overlapping, counts.behind_queues, counts.in_turn);
    EXPECT_GT(counts.overlapping, 1000u);
    EXPECT_GT(counts.behind_queues, 100u);
    EXPECT_GT(counts.in_turn, 1000u);
}

}  // namespace
}  // namespace weft::test

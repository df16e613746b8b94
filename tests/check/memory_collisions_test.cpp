// Compares memory_collisions() with a simple search over all pairs. Two resources collide if they share bytes
// while both are alive.
#include "check/structure/memory_collisions.h"

#include <gtest/gtest.h>

#include "tests/check/random_placements.h"

namespace weft::test {
namespace {

using Pairs = std::vector<std::pair<uint32_t, uint32_t>>;

Pairs by_all_pairs(const FramePlan& plan) {
    Pairs pairs;
    const std::vector<Placement>& all = plan.memory.placements;
    for (uint32_t i = 0; i < all.size(); ++i)
        for (uint32_t j = i + 1; j < all.size(); ++j) {
            const Placement &a = all[i], &b = all[j];
            const LifetimeSpan &s = plan.lifetimes.spans[a.resource], &t = plan.lifetimes.spans[b.resource];
            const bool always =
                check::outlives_the_frame(plan, a.resource) || check::outlives_the_frame(plan, b.resource);
            const bool same_time = always || (s.first <= t.last && t.first <= s.last);
            const bool same_bytes =
                a.heap == b.heap && a.offset_bytes < b.end_bytes() && b.offset_bytes < a.end_bytes();
            if (same_time && same_bytes) pairs.emplace_back(i, j);
        }
    return pairs;
}

TEST(MemoryCollisions, AreThoseOfAllPairs) {
    uint32_t with = 0, without = 0;
    for (uint32_t seed = 1; seed <= 600; ++seed) {
        // Few small resources, so that about half of the plans have no collision.
        FramePlan plan = random_placements(seed, 3 + seed % 10, 200, 20, 8);
        if (seed % 5 == 0) plan.graph.resources[ResourceId(1)].lifetime = ResourceLifetime::persistent;
        const Pairs expected = by_all_pairs(plan);
        EXPECT_EQ(check::memory_collisions(plan), expected) << "seed " << seed;
        ++(expected.empty() ? without : with);
    }
    EXPECT_GT(with, 50u);
    EXPECT_GT(without, 50u);
}

// Fifty resources share bytes, but use them one after another, so they do not collide. Then the test extends
// the lifetime of resource 48, so that it overlaps the lifetime of resource 49 by one position.
TEST(MemoryCollisions, OneSharedPositionIsFound) {
    FramePlan plan = random_placements(1, 50, 200, 20, 8);
    for (ResourceId id(0); id < 50; ++id) {
        plan.memory.placements[id] = {id, 0, id % 3u, 10};
        plan.lifetimes.spans[id].first = Position(2 * id);
        plan.lifetimes.spans[id].last = Position(2 * id + 1);
    }
    EXPECT_TRUE(check::memory_collisions(plan).empty());
    plan.lifetimes.spans[ResourceId(48)].last = Position(98);
    EXPECT_EQ(check::memory_collisions(plan), (Pairs{{48, 49}}));
}

}  // namespace
}  // namespace weft::test

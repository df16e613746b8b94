// Compares MemoryHolders with a model that stores the holders of each single byte.
#include "check/memory_holders.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "tests/check/random_placements.h"

namespace weft::test {
namespace {

using check::MemoryHolders;

class ByteModel {
 public:
    explicit ByteModel(const FramePlan& plan) : plan_(plan) {}

    std::vector<ResourceId> take_over(ResourceId taker) {
        const std::vector<ResourceId> old = others(taker);
        if (!old.empty()) taken_from_[taker] = old;
        each_byte(taker, [&](std::set<ResourceId>& holders) { holders = {taker}; });
        return old;
    }
    void use(ResourceId resource) {
        each_byte(resource, [&](std::set<ResourceId>& holders) { holders.insert(resource); });
    }
    std::vector<ResourceId> to_wait_for(ResourceId taker) {
        const std::vector<ResourceId> now = others(taker);
        return now.empty() ? taken_from_[taker] : now;
    }

 private:
    template <class Visit>
    void each_byte(ResourceId resource, Visit visit) {
        const Placement& p = plan_.memory.placements[resource];
        for (uint64_t at = p.offset_bytes; at < p.end_bytes(); ++at) visit(bytes_[{p.heap, at}]);
    }
    std::vector<ResourceId> others(ResourceId resource) {
        std::set<ResourceId> found;
        each_byte(resource,
                  [&](const std::set<ResourceId>& holders) { found.insert(holders.begin(), holders.end()); });
        found.erase(resource);
        return {found.begin(), found.end()};
    }

    const FramePlan& plan_;
    std::map<std::pair<uint32_t, uint64_t>, std::set<ResourceId>> bytes_;
    std::map<ResourceId, std::vector<ResourceId>> taken_from_;
};

std::vector<ResourceId> copy(std::span<const ResourceId> list) {
    return {list.begin(), list.end()};
}

// In each step, a random resource either uses its memory or takes it over, and all answers are compared with
// the model. On average, `uses` of 10 steps are calls of use(); the others are calls of take_over().
void compare(uint32_t seed, uint32_t most_bytes, uint32_t uses) {
    const FramePlan plan = random_placements(seed, 40, 60, most_bytes, 10);
    MemoryHolders holders(plan);
    ByteModel model(plan);
    std::mt19937 random(seed);
    for (uint32_t step = 0; step < 400; ++step) {
        const ResourceId resource(static_cast<uint32_t>(random() % 40));
        EXPECT_EQ(copy(holders.to_wait_for(resource)), model.to_wait_for(resource))
            << "seed " << seed << ", step " << step;
        if (random() % 10 < uses) {
            holders.use(resource);
            model.use(resource);
        } else {
            EXPECT_EQ(copy(holders.take_over(resource)), model.take_over(resource))
                << "seed " << seed << ", step " << step;
        }
        if (::testing::Test::HasFailure()) return;
    }
}

TEST(MemoryHolders, KnowsTheHoldersOfEveryByte) {
    for (uint32_t seed = 1; seed <= 40; ++seed) {
        compare(seed, 20, 0);
        compare(seed, 20, 3);
        compare(seed, 60, 2);
        compare(seed, 3, 5);
    }
}

// A resource without a place, such as an import, holds no memory.
TEST(MemoryHolders, AResourceWithoutAPlaceTakesNothing) {
    FramePlan plan = random_placements(1, 3, 10, 10, 10);
    plan.memory.placements.pop_back();
    MemoryHolders holders(plan);
    holders.use(ResourceId(0));
    holders.use(ResourceId(2));
    EXPECT_TRUE(holders.take_over(ResourceId(2)).empty());
    EXPECT_TRUE(holders.to_wait_for(ResourceId(2)).empty());
}

}  // namespace
}  // namespace weft::test

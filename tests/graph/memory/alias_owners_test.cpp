// Compares OwnerMap with a list that stores the owner of each single byte.
#include "graph/memory/alias_owners.h"

#include <gtest/gtest.h>

#include <random>

namespace weft::test {
namespace {

// Takes random byte ranges, both from an OwnerMap and from a list of single bytes, and compares the old
// owners that each take finds. Consecutive bytes with the same owner count once.
void compare(uint32_t seed, uint64_t heap_bytes, uint64_t most_bytes) {
    std::mt19937 random(seed);
    OwnerMap map;
    std::vector<ResourceId> bytes(heap_bytes, kNoId);
    for (uint32_t step = 0; step < 600; ++step) {
        const ResourceId owner(step);
        const uint64_t begin = random() % heap_bytes;
        const uint64_t end = std::min(heap_bytes, begin + 1 + random() % most_bytes);
        std::vector<ResourceId> expected;
        for (uint64_t at = begin; at < end; ++at) {
            if (bytes[at] != kNoId && (expected.empty() || expected.back() != bytes[at]))
                expected.push_back(bytes[at]);
            bytes[at] = owner;
        }
        std::vector<Owner> found;
        map.take(begin, end, {owner, step}, found);
        ASSERT_EQ(found.size(), expected.size()) << "seed " << seed << ", step " << step;
        for (size_t i = 0; i < found.size(); ++i) {
            EXPECT_EQ(found[i].resource, expected[i]) << "seed " << seed << ", step " << step;
            EXPECT_EQ(found[i].frame, uint32_t{expected[i]}) << "seed " << seed << ", step " << step;
        }
    }
}

TEST(OwnerMap, KnowsTheLastOwnerOfEveryByte) {
    for (uint32_t seed = 1; seed <= 20; ++seed) {
        compare(seed, 60, 20);
        // The map then has several hundred ranges, so that it divides its list of ranges into parts.
        compare(seed, 4000, 12);
        compare(seed, 4000, 1500);
    }
}

}  // namespace
}  // namespace weft::test

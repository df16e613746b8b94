// Compares SortedList with std::set.
#include "graph/memory/sorted_list.h"

#include <gtest/gtest.h>

#include <iterator>
#include <random>
#include <set>

namespace weft::test {
namespace {

TEST(SortedList, FindsTheKeysThatASetFinds) {
    for (uint32_t seed = 1; seed <= 10; ++seed) {
        std::mt19937 random(seed);
        SortedList<uint32_t> list;
        std::set<uint32_t> set;
        const auto even = [](uint32_t key) { return key % 2 == 0; };
        // At first most steps insert a key, so that the list is divided into parts; later most steps remove
        // one.
        for (uint32_t step = 0; step < 4000; ++step) {
            const uint32_t key = random() % 5000;
            if (random() % 10 < (step < 2000 ? 8u : 2u)) {
                if (set.insert(key).second) list.insert(key);
            } else if (const auto found = set.lower_bound(key); found != set.end()) {
                list.erase(uint32_t{*found});
                set.erase(found);
            }
            auto expected = set.lower_bound(key);
            while (expected != set.end() && !even(*expected)) ++expected;
            const uint32_t* found = list.find(key, even);
            ASSERT_EQ(found == nullptr, expected == set.end()) << "seed " << seed << ", step " << step;
            if (found == nullptr) continue;
            EXPECT_EQ(*found, *expected) << "seed " << seed << ", step " << step;
        }
    }
}

}  // namespace
}  // namespace weft::test

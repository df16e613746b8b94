#include "graph/memory/alias_pack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "graph/memory/alias_best_fit.h"
#include "graph/memory/alias_eject.h"

namespace weft::test {
namespace {

bool sound(const std::vector<PackItem>& items, const Packing& packing) {
    for (size_t i = 0; i < items.size(); ++i) {
        const uint64_t begin = packing.offsets_bytes[i], end = begin + items[i].size_bytes;
        if (begin % items[i].alignment_bytes != 0 || end > packing.height_bytes) return false;
        for (size_t j = 0; j < i; ++j) {
            const bool together = items[j].first <= items[i].last && items[i].first <= items[j].last;
            const uint64_t other = packing.offsets_bytes[j];
            if (together && other < end && begin < other + items[j].size_bytes) return false;
        }
    }
    return true;
}

std::vector<PackItem> random_items(uint32_t seed, uint32_t count, uint32_t longest) {
    std::mt19937 random(seed);
    std::vector<PackItem> items;
    for (uint32_t i = 0; i < count; ++i) {
        const auto first = static_cast<uint32_t>(random() % count);
        items.push_back({1 + random() % 5000, uint64_t{1} << (random() % 9), first,
                         first + static_cast<uint32_t>(random() % longest)});
    }
    return items;
}

uint64_t peak_bytes(const std::vector<PackItem>& items) {
    uint64_t peak = 0;
    for (const PackItem& at : items) {
        uint64_t bytes = 0;
        for (const PackItem& item : items)
            if (item.first <= at.first && at.first <= item.last) bytes += item.size_bytes;
        peak = std::max(peak, bytes);
    }
    return peak;
}

TEST(Pack, NothingThatLivesTogetherSharesBytes) {
    for (uint32_t seed = 0; seed < 60; ++seed) {
        // With short lifetimes pack() uses its algorithm for sparse conflicts, with long lifetimes the one
        // for dense conflicts.
        const std::vector<PackItem> items = random_items(seed, 40 + seed, seed % 2 ? 4 : 40);
        EXPECT_TRUE(sound(items, pack_sweep(items))) << "seed " << seed;
        EXPECT_TRUE(sound(items, pack_sweep_back(items))) << "seed " << seed;
        EXPECT_TRUE(sound(items, pack_size_descending(items))) << "seed " << seed;
        const Packing best = pack(items, peak_bytes(items));
        EXPECT_TRUE(sound(items, best)) << "seed " << seed;
        EXPECT_LE(best.height_bytes, pack_sweep(items).height_bytes);
        EXPECT_LE(best.height_bytes, pack_size_descending(items).height_bytes);
    }
}

// Items A, B and C have 2, 2 and 4 bytes. B is alive together with A and with C. B is placed above A, so C
// fits only above B. With a target of six bytes, C takes the place of B, and B is placed above C.
TEST(Pack, AnItemThatDoesNotFitTakesThePlaceOfAnother) {
    const std::vector<PackItem> a_b_c{{2, 1, 0, 0}, {2, 1, 0, 1}, {4, 1, 1, 1}};
    Conflicts conflicts(a_b_c);
    const Packing simple = pack_in_order(a_b_c, {0, 1, 2}, conflicts);
    EXPECT_EQ(simple.offsets_bytes, (std::vector<uint64_t>{0, 2, 4}));
    EXPECT_EQ(simple.height_bytes, 8u);
    const Packing below = pack_below(a_b_c, {0, 1, 2}, 6, 3, conflicts);
    EXPECT_EQ(below.offsets_bytes, (std::vector<uint64_t>{0, 4, 0}));
    EXPECT_EQ(below.height_bytes, 6u);
}

// Tests both forms of Conflicts. If eight items are all alive together, Conflicts is dense: it has no lists.
// If 40 items are alive in pairs, Conflicts is sparse: each item has a list of the items that are alive with
// it.
TEST(Conflicts, ARemovedItemTakesNoBytes) {
    std::vector<PackItem> together(8, {4, 1, 0, 0}), apart;
    for (uint32_t i = 0; i < 40; ++i) apart.push_back({4, 1, i / 2, i / 2});
    for (const std::vector<PackItem>& items : {together, apart}) {
        Conflicts conflicts(items);
        EXPECT_EQ(conflicts.dense(), items.size() == 8);
        conflicts.place(1, 12);
        ASSERT_EQ(conflicts.taken(0).size(), 1u);
        EXPECT_EQ(conflicts.taken(0)[0].begin_bytes, 12u);
        EXPECT_EQ(conflicts.taken(0)[0].end_bytes, 16u);
        EXPECT_EQ(conflicts.taken(0)[0].item, 1u);
        conflicts.remove(1);
        EXPECT_TRUE(conflicts.taken(0).empty());
    }
}

// Checks pack_below() with lists of conflicts (short lifetimes) and without (long lifetimes), and with a
// target that it cannot reach.
TEST(Pack, EjectionReachesTheTargetOrPlacesTheRestAboveIt) {
    size_t reached = 0, smaller = 0;
    for (uint32_t seed = 0; seed < 60; ++seed) {
        std::vector<PackItem> items = random_items(seed, 80, seed % 2 ? 6 : 60);
        std::vector<uint32_t> order(items.size());
        std::iota(order.begin(), order.end(), 0u);
        Conflicts conflicts(items);
        const uint64_t peak = peak_bytes(items), target = peak + peak / 20;
        const Packing packing = pack_below(items, order, target, items.size(), conflicts);
        EXPECT_TRUE(sound(items, packing)) << "seed " << seed;
        reached += packing.height_bytes <= target ? 1 : 0;
        smaller += packing.height_bytes < pack_in_order(items, order, conflicts).height_bytes ? 1 : 0;
        EXPECT_TRUE(sound(items, pack_below(items, order, peak / 2, items.size(), conflicts))) << "seed " << seed;
    }
    std::printf("%zu of 60 packings reach the target, %zu are smaller than without ejection\n", reached,
                smaller);
    EXPECT_GT(reached, 20u);
    EXPECT_GT(smaller, 30u);
}

// The same items as in AnItemThatDoesNotFitTakesThePlaceOfAnother. Only C ends above the target of six bytes,
// so only C is placed again, and B is removed for it. If no removal is allowed, C stays above the target.
TEST(Pack, LoweringPlacesOnlyItemsAboveTheTargetAgain) {
    const std::vector<PackItem> a_b_c{{2, 1, 0, 0}, {2, 1, 0, 1}, {4, 1, 1, 1}};
    Conflicts conflicts(a_b_c);
    const Packing simple = pack_in_order(a_b_c, {0, 1, 2}, conflicts);
    const Packing lowered = lower(a_b_c, {0, 1, 2}, simple, 6, 1, conflicts);
    EXPECT_EQ(lowered.offsets_bytes, (std::vector<uint64_t>{0, 4, 0}));
    EXPECT_EQ(lowered.height_bytes, 6u);
    EXPECT_EQ(lower(a_b_c, {0, 1, 2}, simple, 6, 0, conflicts).offsets_bytes, simple.offsets_bytes);
}

TEST(Pack, LoweringReachesTheTargetOrPlacesTheRestAboveIt) {
    size_t reached = 0;
    for (uint32_t seed = 0; seed < 60; ++seed) {
        const std::vector<PackItem> items = random_items(seed, 80, seed % 2 ? 6 : 60);
        std::vector<uint32_t> order(items.size());
        std::iota(order.begin(), order.end(), 0u);
        Conflicts conflicts(items);
        const uint64_t peak = peak_bytes(items), target = peak + peak / 20;
        const Packing sweep = pack_sweep(items);
        const Packing packing = lower(items, order, sweep, target, items.size(), conflicts);
        EXPECT_TRUE(sound(items, packing)) << "seed " << seed;
        reached += packing.height_bytes <= target ? 1 : 0;
        EXPECT_TRUE(sound(items, lower(items, order, sweep, peak / 2, items.size(), conflicts)))
            << "seed " << seed;
    }
    std::printf("%zu of 60 packings reach the target\n", reached);
    EXPECT_GT(reached, 20u);
}

TEST(Pack, StaysNearTheLowerBound) {
    double sum = 0;
    for (uint32_t seed = 0; seed < 20; ++seed) {
        std::vector<PackItem> items = random_items(seed, 100, 30);
        for (PackItem& item : items) item.alignment_bytes = 1;
        const uint64_t peak = peak_bytes(items);
        sum += static_cast<double>(pack(items, peak).height_bytes) / static_cast<double>(peak);
    }
    EXPECT_LE(sum / 20, 1.05);
}

}  // namespace
}  // namespace weft::test

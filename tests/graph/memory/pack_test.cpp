#include "graph/memory/alias_pack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

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
        EXPECT_TRUE(sound(items, pack_size_descending(items))) << "seed " << seed;
        const Packing best = pack(items, peak_bytes(items));
        EXPECT_TRUE(sound(items, best)) << "seed " << seed;
        EXPECT_LE(best.height_bytes, pack_sweep(items).height_bytes);
        EXPECT_LE(best.height_bytes, pack_size_descending(items).height_bytes);
    }
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

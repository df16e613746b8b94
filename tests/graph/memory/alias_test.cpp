#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "graph/memory/alias_hand_over.h"
#include "graph/memory/alias_pack.h"
#include "tests/graph/compile/plan_expectations.h"

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
        // Short lifetimes test the sparse algorithm, long ones the dense one.
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

// A chain of images of equal size, which alternate between two places.
FramePlan chain(uint32_t length) {
    GraphBuilder b;
    std::vector<ResourceId> images;
    for (uint32_t i = 0; i < length; ++i) images.push_back(b.image("i" + std::to_string(i)));
    b.compute("p0", {{"dst", images[0], Access::storage_write, {}, kNoId}});
    for (uint32_t i = 1; i < length; ++i)
        b.compute("p" + std::to_string(i), {{"src", images[i - 1], Access::sampled_read, {}, kNoId},
                                            {"dst", images[i], Access::storage_write, {}, kNoId}});
    read_back(b, "out", images.back());
    return compiled(b);
}

TEST(Alias, AChainNeedsTwoPlacesAndHandsThemOver) {
    const FramePlan plan = chain(5);
    EXPECT_EQ(plan.memory.sum_bytes, 5u * 1024);
    EXPECT_EQ(plan.memory.peak_live_bytes, 2u * 1024);
    EXPECT_EQ(plan.memory.heap_bytes, 2u * 1024);
    const auto id = [&](const char* name) { return resource_id(plan, name); };
    // i0 i2 i4 share one place, i1 i3 the other; the first of each takes over from the last one of the
    // previous frame.
    const std::vector<HandOver> wanted{{id("i4"), id("i0"), true},
                                       {id("i3"), id("i1"), true},
                                       {id("i0"), id("i2"), false},
                                       {id("i1"), id("i3"), false},
                                       {id("i2"), id("i4"), false}};
    EXPECT_EQ(plan.memory.hand_overs, wanted);
}

TEST(Alias, AResourceAloneHandsOverToItself) {
    const FramePlan plan = chain(1);
    EXPECT_EQ(plan.memory.hand_overs, (std::vector<HandOver>{{0, 0, true}}));
}

TEST(Alias, HandOversFollowTheBytes) {
    // In a heap of 100 bytes: first 0, then 1, both beside 2; then 3 in the memory of both.
    const std::vector<Placement> placements{{0, 0, 0, 60}, {1, 0, 0, 50}, {2, 0, 50, 50}, {3, 0, 0, 100}};
    Lifetimes spans;
    spans.spans = {{0, 1}, {2, 3}, {2, 3}, {4, 5}};
    const std::vector<HandOver> wanted{{3, 0, true}, {0, 1, false}, {0, 2, false},
                                       {3, 2, true}, {1, 3, false}, {2, 3, false}};
    EXPECT_EQ(hand_overs(placements, spans), wanted);
}

// One buffer and one image alive at the same time, then another buffer and image.
GraphBuilder mixed() {
    GraphBuilder b;
    const ResourceId image = b.image("image", Format::r32u, 10), words = b.buffer("words", 1000);
    b.compute("make", {{"dst", image, Access::storage_write, {}, kNoId}});
    b.compute("convert", {{"src", image, Access::sampled_read, {}, kNoId},
                          {"dst", words, Access::storage_write, {}, kNoId}});
    read_back(b, "out", words);
    return b;
}

TEST(Alias, BuffersAndImagesKeepToPagesOfTheirOwn) {
    const ResolvedGraph graph = mixed().build();
    const FramePlan small = compile(graph, content_needs(graph, 1), {false, 256});
    ASSERT_EQ(small.memory.heaps.size(), 1u);
    for (const Placement& p : small.memory.placements) EXPECT_EQ(p.offset_bytes % 256, 0u);
    const FramePlan large = compile(graph, content_needs(graph, 1), {false, 65536});
    ASSERT_EQ(large.memory.heaps.size(), 2u);
    EXPECT_NE(large.memory.heaps[0].buffers, large.memory.heaps[1].buffers);
}

TEST(Alias, MemoryTypesAreRespected) {
    const ResolvedGraph graph = mixed().build();
    MemoryNeeds needs = content_needs(graph, 1);
    needs[0].type_bits = 2;
    needs[1].type_bits = 4;
    const FramePlan plan = compile(graph, needs, {});
    ASSERT_EQ(plan.memory.heaps.size(), 2u);
    for (const Placement& p : plan.memory.placements)
        EXPECT_EQ(plan.memory.heaps[p.heap].type_bits, needs[p.resource].type_bits);
}

}  // namespace
}  // namespace weft::test

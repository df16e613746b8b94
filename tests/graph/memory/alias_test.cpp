// Tests the memory plan: the heaps, the offsets of resources in them, and which resource takes over memory
// from which.
#include "graph/memory/alias.h"

#include <gtest/gtest.h>

#include "graph/memory/alias_transitions.h"
#include "tests/graph/samples/graph_builder.h"
#include "tests/graph/samples/hand_made.h"

namespace weft::test {
namespace {

ResolvedGraph images(uint32_t count) {
    GraphBuilder b;
    for (uint32_t i = 0; i < count; ++i) b.image("i" + std::to_string(i));
    return b.build();
}

LifetimeSpan span(Position first, Position last, QueueIndex queue = kGraphicsQueue) {
    return {first, last, {{queue, first, last}}};
}

Schedule one_queue() {
    Schedule order;
    order.queue.assign(8, 0);
    return order;
}

MemoryPlan aliased(const ResolvedGraph& graph, const Schedule& order, std::vector<LifetimeSpan> spans,
                   const MemoryNeeds& needs, uint64_t granularity_bytes = 64) {
    return alias(graph, all_live(graph), order, {std::move(spans)}, needs, granularity_bytes);
}

const Placement& place_of(const MemoryPlan& plan, ResourceId id) {
    static const Placement kNowhere;
    for (const Placement& p : plan.placements)
        if (p.resource == id) return p;
    ADD_FAILURE() << "resource " << id << " has no place";
    return kNowhere;
}

// Each of the five images lives at the same time as the next one. So two places in memory are enough, and the
// images use the places alternately.
TEST(Alias, AChainNeedsTwoPlacesAndTakesThemOverInTurn) {
    const MemoryPlan plan =
        aliased(images(5), one_queue(), {span(0, 1), span(1, 2), span(2, 3), span(3, 4), span(4, 5)},
                MemoryNeeds(5, {1024, 1, UINT32_MAX}));
    EXPECT_EQ(plan.sum_bytes, 5120u);
    EXPECT_EQ(plan.peak_live_bytes, 2048u);
    EXPECT_EQ(plan.peak_position, 1u);
    EXPECT_EQ(plan.heap_bytes, 2048u);
    ASSERT_EQ(plan.heaps.size(), 1u);
    for (const ResourceId id : {ResourceId(2), ResourceId(4)})
        EXPECT_EQ(place_of(plan, id).offset_bytes, place_of(plan, 0).offset_bytes) << id;
    EXPECT_EQ(place_of(plan, 3).offset_bytes, place_of(plan, 1).offset_bytes);
    EXPECT_NE(place_of(plan, 0).offset_bytes, place_of(plan, 1).offset_bytes);
    const std::vector<AliasTransition> wanted{
        {4, 0, true}, {3, 1, true}, {0, 2, false}, {1, 3, false}, {2, 4, false}};
    EXPECT_EQ(plan.alias_transitions, wanted);
}

TEST(Alias, AResourceAloneTakesItsBytesOverFromItself) {
    const MemoryPlan plan = aliased(images(1), one_queue(), {span(0, 1)}, {{1024, 1, UINT32_MAX}});
    EXPECT_EQ(plan.alias_transitions, (std::vector<AliasTransition>{{0, 0, true}}));
}

TEST(Alias, BytesAreSharedBetweenQueuesOnlyWhereClocksProveTheOrder) {
    Schedule order;
    order.queue = {0, 1};
    order.queues = two_queues();
    for (const bool ordered : {false, true}) {
        order.clocks = {2, {0, 0, ordered ? 1u : 0u, 0}};
        const MemoryPlan plan =
            aliased(images(2), order, {span(0, 0, 0), span(1, 1, 1)}, MemoryNeeds(2, {1024, 1, UINT32_MAX}));
        EXPECT_EQ(plan.heap_bytes, ordered ? 1024u : 2048u);
        EXPECT_EQ(plan.alias_transitions.front(),
                  (ordered ? AliasTransition{1, 0, true} : AliasTransition{0, 0, true}));
    }
}

// A buffer and an image live at the same time. They must not share a page of the device's buffer-image
// granularity.
TEST(Alias, BuffersAndImagesKeepToPagesOfTheirOwn) {
    GraphBuilder b;
    b.buffer("buffer"), b.image("image");
    const ResolvedGraph graph = b.build();
    const std::vector<LifetimeSpan> spans{span(0, 1), span(0, 1)};
    const MemoryNeeds needs{{1000, 1, UINT32_MAX}, {400, 1, UINT32_MAX}};
    const MemoryPlan small = aliased(graph, one_queue(), spans, needs, 256);
    ASSERT_EQ(small.heaps.size(), 1u);
    EXPECT_EQ(small.heap_bytes, 1024u + 512u);
    for (const Placement& p : small.placements) EXPECT_EQ(p.offset_bytes % 256, 0u);
    EXPECT_EQ(place_of(small, 0).size_bytes, 1000u) << "pages pad the offset, not the size";
    const MemoryPlan large = aliased(graph, one_queue(), spans, needs, 65536);
    ASSERT_EQ(large.heaps.size(), 2u);
    EXPECT_FALSE(large.heaps[0].buffers);
    EXPECT_EQ(large.heaps[0].size_bytes, 400u);
    EXPECT_TRUE(large.heaps[1].buffers);
    EXPECT_EQ(large.heaps[1].size_bytes, 1000u);
}

TEST(Alias, ResourcesOfDifferentMemoryTypesHaveDifferentHeaps) {
    const MemoryPlan plan =
        aliased(images(2), one_queue(), {span(0, 0), span(1, 1)}, {{100, 1, 4}, {60, 1, 2}});
    ASSERT_EQ(plan.heaps.size(), 2u);
    EXPECT_EQ(plan.heaps[place_of(plan, 0).heap].type_bits, 4u);
    EXPECT_EQ(plan.heaps[place_of(plan, 1).heap].type_bits, 2u);
    EXPECT_EQ(plan.heap_bytes, 160u);
}

TEST(Alias, WhatOutlivesTheFrameSharesNothing) {
    GraphBuilder b;
    for (const char* name : {"a", "b"}) b.ring(b.image(name), 0);
    const MemoryPlan plan = aliased(b.build(), one_queue(), {{}, {}}, {{100, 4, 1}, {60, 4, 1}});
    ASSERT_EQ(plan.heaps.size(), 1u);
    EXPECT_TRUE(plan.heaps[0].persistent);
    EXPECT_EQ(place_of(plan, 0).offset_bytes, 0u);
    EXPECT_EQ(place_of(plan, 1).offset_bytes, 128u) << "the next multiple of the granularity";
    EXPECT_EQ(plan.persistent_bytes, 188u);
    EXPECT_EQ(plan.heap_bytes, 0u);
    EXPECT_TRUE(plan.alias_transitions.empty());
}

TEST(Alias, WhatNoPassUsesOrNeedsNoMemoryHasNoPlace) {
    const MemoryPlan plan = aliased(images(3), one_queue(), {{}, span(0, 1), span(0, 1)},
                                    {{100, 1, UINT32_MAX}, {0, 1, UINT32_MAX}, {60, 1, UINT32_MAX}});
    ASSERT_EQ(plan.placements.size(), 1u);
    EXPECT_EQ(plan.placements[0].resource, 2u);
}

TEST(AliasTransitions, FollowTheBytes) {
    // One heap has 100 bytes. Resource 0 uses bytes 0 to 59. Later, resource 1 uses bytes 0 to 49, and at the
    // same time resource 2 uses bytes 50 to 99. Then resource 3 uses all 100 bytes.
    const std::vector<Placement> placements{{0, 0, 0, 60}, {1, 0, 0, 50}, {2, 0, 50, 50}, {3, 0, 0, 100}};
    const std::vector<AliasTransition> wanted{{3, 0, true}, {0, 1, false}, {0, 2, false},
                                              {3, 2, true}, {1, 3, false}, {2, 3, false}};
    EXPECT_EQ(alias_transitions(placements, {{{0, 1}, {2, 3}, {2, 3}, {4, 5}}}), wanted);
}

}  // namespace
}  // namespace weft::test

// Tests where barriers are recorded, and the source states of barriers of resources that take over memory.
#include "graph/sync/barriers.h"

#include <gtest/gtest.h>

#include "tests/graph/compile/plan_expectations.h"
#include "tests/graph/samples/graph_builder.h"
#include "tests/graph/samples/hand_made.h"

namespace weft::test {
namespace {

constexpr AccessState kWrite{stage::kComputeShader, access::kStorageWrite, Layout::general};

// Returns a graph with the images a, b and c, which the passes pa, pb and pc write. Image b has two mips, of
// which pb writes `part_of_b`, by default both.
ResolvedGraph three_images(std::optional<SubresourceRange> part_of_b = {}) {
    GraphBuilder builder;
    const ResourceId a = builder.image("a"), b = builder.image("b", Format::r32u, 16, 2);
    const ResourceId c = builder.image("c");
    builder.compute("pa", {{"dst", a, Access::storage_write, {}, 0}});
    builder.compute("pb", {{"dst", b, Access::storage_write, part_of_b, 0}});
    builder.compute("pc", {{"dst", c, Access::storage_write, {}, 0}});
    return builder.build();
}

SyncTable empty_table(const ResolvedGraph& graph) {
    SyncTable table;
    table.histories = HistoryTable(graph.resources.size());
    table.concurrent.assign(graph.resources.size(), 0);
    table.scopes.assign(graph.passes.size(), kNoId);
    return table;
}

PlacedBarrier taking_over(Position position) {
    TrackedBarrier barrier;
    barrier.dst = kWrite;
    barrier.reason = BarrierReason::alias;
    return {position, false, barrier};
}

TEST(Barriers, AreRecordedBeforeOrBehindTheirPassOrAtTheEndOfTheFrame) {
    const ResolvedGraph graph = three_images();
    SyncTable sync = empty_table(graph);
    TrackedBarrier raw;
    raw.dst = kWrite;
    sync.histories.set(1, {.barriers = {{0, true, raw}, {2, false, raw}, {kEpiloguePosition, false, raw}}});
    const BarrierResult result = barriers(graph, in_order(graph, {"pa", "pb", "pc"}), sync, {}, {{}, {}, {}});
    ASSERT_EQ(result.plan.steps.size(), 3u);
    ASSERT_EQ(result.plan.steps[0].after.size(), 1u);
    EXPECT_EQ(result.plan.steps[0].after[0].to, kNoId);
    ASSERT_EQ(result.plan.steps[2].barriers.size(), 1u);
    EXPECT_EQ(result.plan.steps[2].barriers[0].resource, 1u);
    EXPECT_EQ(result.plan.steps[2].barriers[0].to, pass_of(graph, "pc"));
    EXPECT_EQ(result.plan.epilogue.size(), 1u);
    EXPECT_EQ(result.plan.emitted, 3u);
    EXPECT_TRUE(result.memory_dependencies.empty());
}

TEST(Barriers, StepsTakeOverTheirAttachmentsScopesAndPasses) {
    const ResolvedGraph graph = three_images();
    SyncTable sync = empty_table(graph);
    sync.scopes = {kNoId, 0, kNoId};
    sync.concurrent = {0, 1, 0};
    const BarrierPlan plan = barriers(graph, in_order(graph, {"pc", "pa", "pb"}), sync, {},
                                      {{}, {{3, LoadOp::load, StoreOp::none}}, {}})
                                 .plan;
    EXPECT_EQ(plan.steps[0].pass, pass_of(graph, "pc"));
    EXPECT_FALSE(plan.steps[0].merges_render_pass);
    EXPECT_TRUE(plan.steps[1].merges_render_pass);
    ASSERT_EQ(plan.steps[1].attachments.size(), 1u);
    EXPECT_EQ(plan.steps[1].attachments[0].use, 3u);
    EXPECT_EQ(plan.concurrent, sync.concurrent);
}

TEST(Barriers, MemoryIsTakenOverFromTheLastUsersOfItsOwner) {
    const ResolvedGraph graph = three_images();
    SyncTable sync = empty_table(graph);
    sync.histories.set(0,
                       {.last_uses = {{0, 0, stage::kCopy, access::kTransferWrite, pass_of(graph, "pa")}}});
    sync.histories.set(1, {.barriers = {taking_over(1)}});
    MemoryPlan memory;
    memory.alias_transitions = {{0, 1, false}};
    const BarrierResult result =
        barriers(graph, in_order(graph, {"pa", "pb", "pc"}), sync, memory, {{}, {}, {}});
    ASSERT_EQ(result.plan.steps[1].barriers.size(), 1u);
    const BarrierDecl& barrier = result.plan.steps[1].barriers[0];
    expect_state(barrier.src, {stage::kCopy, access::kTransferWrite, Layout::undefined});
    expect_state(barrier.dst, kWrite);
    EXPECT_EQ(barrier.from, pass_of(graph, "pa"));
    EXPECT_FALSE(barrier.from_previous_frame);
    EXPECT_EQ(barrier.aliased_from, (std::vector<ResourceId>{0}));
    EXPECT_TRUE(result.memory_dependencies.empty());
}

TEST(Barriers, MemoryThatNoOtherResourceHeldComesFromTheFrameBefore) {
    const ResolvedGraph graph = three_images();
    SyncTable sync = empty_table(graph);
    sync.histories.set(1,
                       {.barriers = {taking_over(1)},
                        .last_uses = {{0, 2, stage::kComputeShader, access::kNone, pass_of(graph, "pc")}}});
    const BarrierResult result = barriers(graph, in_order(graph, {"pa", "pb", "pc"}), sync, {}, {{}, {}, {}});
    const BarrierDecl& barrier = result.plan.steps[1].barriers.at(0);
    expect_state(barrier.src, {stage::kComputeShader, access::kNone, Layout::undefined});
    EXPECT_TRUE(barrier.from_previous_frame);
    EXPECT_EQ(barrier.aliased_from, (std::vector<ResourceId>{1}));
}

TEST(Barriers, MemoryOfAnotherQueueIsWaitedForAcrossTheFrameBoundaryOnly) {
    const ResolvedGraph graph = three_images();
    for (const bool wrap : {false, true}) {
        SyncTable sync = empty_table(graph);
        sync.histories.set(
            0, {.last_uses = {{1, 0, stage::kCopy, access::kTransferWrite, pass_of(graph, "pa")}}});
        sync.histories.set(1, {.barriers = {taking_over(1)}});
        MemoryPlan memory;
        memory.alias_transitions = {{0, 1, wrap}};
        const BarrierResult result =
            barriers(graph, in_order(graph, {"pa", "pb", "pc"}, {1, 0, 0}), sync, memory, {{}, {}, {}});
        expect_state(result.plan.steps[1].barriers.at(0).src,
                     {kWrite.stages, access::kNone, Layout::undefined});
        const std::vector<QueueDependency> wanted{{0, 1, true, 1}};
        EXPECT_EQ(result.memory_dependencies, wrap ? wanted : std::vector<QueueDependency>{});
    }
}

// Images a, b and c use the same bytes one after another. If pb writes only a part of b, pc must also wait
// for the last uses of a.
TEST(Barriers, EarlierOwnersCountWhereTheLastOneWroteOnlyAPart) {
    for (const bool part : {false, true}) {
        const ResolvedGraph graph =
            three_images(part ? std::optional(one_cell(0)) : std::optional<SubresourceRange>());
        SyncTable sync = empty_table(graph);
        sync.histories.set(0, {.last_uses = {{0, 0, stage::kFragmentShader, access::kNone, kNoId}}});
        sync.histories.set(1, {.last_uses = {{0, 1, stage::kCopy, access::kTransferWrite, kNoId}}});
        sync.histories.set(2, {.barriers = {taking_over(2)}});
        MemoryPlan memory;
        memory.alias_transitions = {{2, 0, true}, {0, 1, false}, {1, 2, false}};
        const BarrierResult result =
            barriers(graph, in_order(graph, {"pa", "pb", "pc"}), sync, memory, {{}, {}, {}});
        const BarrierDecl& barrier = result.plan.steps[2].barriers.at(0);
        if (part)
            expect_state(barrier.src, {stage::kCopy | stage::kFragmentShader,
                                       access::kTransferWrite | access::kStorageWrite, Layout::undefined});
        else
            expect_state(barrier.src, {stage::kCopy, access::kTransferWrite, Layout::undefined});
        EXPECT_EQ(barrier.aliased_from, (std::vector<ResourceId>{1}));
    }
}

TEST(Barriers, ThePrologueClearsWhatOutlivesTheFrameIntoItsFirstState) {
    const ResolvedGraph graph = three_images();
    SyncTable sync = empty_table(graph);
    sync.histories.set(2, {.entry = {{kNoId,
                                      graph.resources[2].whole(),
                                      {stage::kNone, access::kNone, Layout::shader_read_only},
                                      0}}});
    const ProloguePlan prologue =
        barriers(graph, in_order(graph, {"pa", "pb", "pc"}), sync, {}, {{}, {}, {}}).plan.prologue;
    EXPECT_EQ(prologue.cleared, (std::vector<ResourceId>{2}));
    ASSERT_EQ(prologue.before.size(), 1u);
    EXPECT_EQ(prologue.before[0].resource, 2u);
    EXPECT_EQ(prologue.before[0].src.layout, Layout::undefined);
    EXPECT_EQ(prologue.before[0].dst.layout, Layout::transfer_dst);
    ASSERT_EQ(prologue.after.size(), 1u);
    EXPECT_EQ(prologue.after[0].src.layout, Layout::transfer_dst);
    EXPECT_EQ(prologue.after[0].dst.layout, Layout::shader_read_only);
}

}  // namespace
}  // namespace weft::test

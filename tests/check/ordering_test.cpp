// The rules of Vulkan's dependencies, one by one, on records made by hand.
#include "check/ordering.h"

#include <gtest/gtest.h>

namespace weft::check {
namespace {

Scopes scopes(StageMask src, AccessMask src_access, StageMask dst, AccessMask dst_access) {
    BarrierDecl barrier;
    barrier.src = {src, src_access, Layout::undefined};
    barrier.dst = {dst, dst_access, Layout::undefined};
    return scopes_of(barrier);
}

void pass(AccessRecord& record, const Scopes& s, bool on_memory) {
    record.pass_barriers({&s, 1}, {&s, on_memory ? 1u : 0u});
}

AccessRecord compute_write() {
    return {Actor{0, 0}, stage::kComputeShader, access::kStorageWrite, true};
}
AccessRecord fragment_read() {
    return {Actor{0, 0}, stage::kFragmentShader, access::kSampledRead, false};
}

const Scopes kComputeToFragment =
    scopes(stage::kComputeShader, access::kStorageWrite, stage::kFragmentShader, access::kSampledRead);

TEST(Ordering, NothingIsOrderedWithoutABarrier) {
    const AccessRecord record = compute_write();
    EXPECT_FALSE(record.ordered_before(stage::kComputeShader));
    EXPECT_FALSE(record.visible_to(stage::kComputeShader, access::kStorageRead));
}

TEST(Ordering, ABarrierMakesAWriteVisibleToItsDestinationOnly) {
    AccessRecord record = compute_write();
    pass(record, kComputeToFragment, true);
    EXPECT_TRUE(record.ordered_before(stage::kFragmentShader));
    EXPECT_TRUE(record.visible_to(stage::kFragmentShader, access::kSampledRead));
    EXPECT_FALSE(record.visible_to(stage::kFragmentShader, access::kStorageRead));
    EXPECT_FALSE(record.ordered_before(stage::kComputeShader));
}

TEST(Ordering, TheExecutionPartHoldsForEverything) {
    AccessRecord record = compute_write();
    pass(record, kComputeToFragment, false);
    EXPECT_TRUE(record.ordered_before(stage::kFragmentShader));
    EXPECT_FALSE(record.available_before(stage::kFragmentShader));
}

TEST(Ordering, DestinationsIncludeLaterStagesForExecutionButNotForMemory) {
    AccessRecord record = compute_write();
    pass(record, kComputeToFragment, true);
    EXPECT_TRUE(record.ordered_before(stage::kColorOutput));
    EXPECT_FALSE(record.ordered_before(stage::kVertexShader));
    EXPECT_FALSE(record.visible_to(stage::kColorOutput, access::kSampledRead));
}

TEST(Ordering, SourcesIncludeEarlierStagesForExecution) {
    AccessRecord record = fragment_read();
    pass(record, scopes(stage::kColorOutput, 0, stage::kComputeShader, 0), false);
    EXPECT_TRUE(record.ordered_before(stage::kComputeShader));
    AccessRecord late(Actor{0, 0}, stage::kColorOutput, access::kColorRead, false);
    pass(late, scopes(stage::kFragmentShader, 0, stage::kComputeShader, 0), false);
    EXPECT_FALSE(late.ordered_before(stage::kComputeShader));
}

TEST(Ordering, BarriersChainWhereTheirScopesMeet) {
    AccessRecord record = compute_write();
    pass(record, kComputeToFragment, true);
    pass(record, scopes(stage::kCopy, 0, stage::kVertexShader, access::kUniformRead), true);
    EXPECT_FALSE(record.ordered_before(stage::kVertexShader));
    pass(record, scopes(stage::kFragmentShader, 0, stage::kCopy, access::kTransferRead), true);
    EXPECT_TRUE(record.ordered_before(stage::kCopy));
    EXPECT_TRUE(record.visible_to(stage::kCopy, access::kTransferRead));
}

TEST(Ordering, BarriersOfOneBatchDoNotChain) {
    AccessRecord record = compute_write();
    const std::array batch{kComputeToFragment,
                           scopes(stage::kFragmentShader, 0, stage::kCopy, access::kTransferRead)};
    record.pass_barriers(batch, batch);
    EXPECT_TRUE(record.ordered_before(stage::kFragmentShader));
    EXPECT_FALSE(record.ordered_before(stage::kCopy));
    EXPECT_FALSE(record.visible_to(stage::kCopy, access::kTransferRead));
}

TEST(Ordering, AWriteIsNotAvailableUntilItsStageAndAccessAreNamed) {
    AccessRecord wrong_access = compute_write();
    pass(wrong_access, scopes(stage::kComputeShader, 0, stage::kFragmentShader, access::kSampledRead), true);
    EXPECT_FALSE(wrong_access.available_before(stage::kFragmentShader));
    EXPECT_FALSE(wrong_access.visible_to(stage::kFragmentShader, access::kSampledRead));
    AccessRecord wrong_stage = compute_write();
    pass(wrong_stage,
         scopes(stage::kCopy, access::kStorageWrite, stage::kFragmentShader, access::kSampledRead), true);
    EXPECT_FALSE(wrong_stage.available_before(stage::kFragmentShader));
}

TEST(Ordering, WhatAnUnrelatedBarrierFlushedIsNotAvailableElsewhere) {
    AccessRecord record = compute_write();
    pass(record, kComputeToFragment, true);
    const Scopes no_flush = scopes(stage::kComputeShader, 0, stage::kVertexShader, access::kStorageRead);
    EXPECT_FALSE(record.available_before(no_flush));
    pass(record, no_flush, true);
    EXPECT_TRUE(record.ordered_before(stage::kVertexShader));
    EXPECT_FALSE(record.visible_to(stage::kVertexShader, access::kStorageRead));
}

TEST(Ordering, EveryStageOfAnAccessMustBeWaitedFor) {
    AccessRecord depth(Actor{0, 0}, stage::kEarlyFragmentTests | stage::kLateFragmentTests,
                       access::kDepthStencilRead | access::kDepthStencilWrite, true);
    pass(depth,
         scopes(stage::kEarlyFragmentTests, access::kDepthStencilWrite, stage::kComputeShader,
                access::kSampledRead),
         true);
    EXPECT_FALSE(depth.ordered_before(stage::kComputeShader));
    EXPECT_FALSE(depth.available_before(stage::kComputeShader));
}

TEST(Ordering, ATransitionIsDoneWhenItsDestinationStarts) {
    const AccessRecord record = AccessRecord::transition(Actor{0, 0}, kComputeToFragment);
    EXPECT_TRUE(record.available_before(stage::kFragmentShader));
    EXPECT_TRUE(record.ordered_before(stage::kFragmentShader));
    EXPECT_TRUE(record.visible_to(stage::kFragmentShader, access::kSampledRead));
    EXPECT_FALSE(record.ordered_before(stage::kComputeShader));
}

}  // namespace
}  // namespace weft::check

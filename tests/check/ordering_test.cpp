// Tests the checker's model of Vulkan's execution and memory dependencies, rule by rule, with hand-made
// access records.
#include "check/ordering.h"

#include <gtest/gtest.h>

#include <random>

namespace weft::check {
namespace {

Scopes scopes(StageMask src, AccessMask src_access, StageMask dst, AccessMask dst_access) {
    BarrierDecl barrier;
    barrier.src = {src, src_access, Layout::undefined};
    barrier.dst = {dst, dst_access, Layout::undefined};
    return scopes_of(barrier);
}

void pass(AccessRecord& record, const Scopes& s, bool on_memory) {
    StageChain all;
    all.add(s);
    record.pass_barriers(all, {&s, on_memory ? 1u : 0u});
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
    StageChain all;
    for (const Scopes& barrier : batch) all.add(barrier);
    record.pass_barriers(all, batch);
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

// Returns for every stage whether the recorded access is ordered before the stage, available before it, and
// visible to it.
std::vector<bool> answers(const AccessRecord& record) {
    std::vector<bool> all;
    for (int s = 0; s < stage::kCount; ++s) {
        all.push_back(record.ordered_before(1u << s));
        all.push_back(record.available_before(1u << s));
        all.push_back(record.visible_to(1u << s, access::kSampledRead));
    }
    return all;
}

TEST(Ordering, FollowingALogIsPassingItsBatchesOneByOne) {
    constexpr unsigned kSeeds = 500;
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const auto few_stages = [&] {
            return (1u << (random() % stage::kCount)) | (1u << (random() % stage::kCount));
        };
        BarrierLog log;
        std::vector<AccessRecord> one_by_one, by_log;
        for (int step = 0; step < 40; ++step) {
            if (random() % 3 == 0) {
                Actor by;
                by.barriers = log.count();
                const AccessRecord record =
                    random() % 2 == 0 ? AccessRecord(by, few_stages(), access::kStorageWrite, true)
                                      : AccessRecord::transition(
                                            by, scopes(few_stages(), 0, few_stages(), access::kSampledRead));
                one_by_one.push_back(record);
                by_log.push_back(record);
                continue;
            }
            StageChain batch;
            Scopes last;
            for (size_t i = 0; i <= random() % 3; ++i)
                batch.add(
                    last = scopes(few_stages(), access::kStorageWrite, few_stages(), access::kSampledRead));
            // In about half of the batches, the last barrier also affects the memory of one record.
            const size_t touched =
                random() % 2 == 0 && !by_log.empty() ? random() % by_log.size() : by_log.size();
            for (size_t i = 0; i < by_log.size(); ++i) {
                one_by_one[i].pass_barriers(batch, {&last, i == touched ? 1u : 0u});
                if (i != touched) continue;
                by_log[i].follow(log);
                by_log[i].pass_barriers(batch, {&last, 1});
            }
            log.append(batch);
        }
        for (size_t i = 0; i < by_log.size(); ++i) {
            by_log[i].follow(log);
            EXPECT_EQ(answers(by_log[i]), answers(one_by_one[i])) << "record " << i;
        }
    }
}

}  // namespace
}  // namespace weft::check

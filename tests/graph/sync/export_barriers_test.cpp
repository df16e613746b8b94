// Tests the barriers around the program's reads of a resource that keeps its content: before the read at the
// end of the frame, and before the next write.
#include <gtest/gtest.h>

#include "tests/graph/compile/plan_expectations.h"

namespace weft::test {
namespace {

// Returns a plan in which pass "look" samples the content of the frame before, and pass "make" writes the
// image afterwards. `between` is the program's read.
FramePlan with_read_between(const AccessState& between) {
    GraphBuilder b;
    const ResourceId map = b.image("map"), seen = b.image("seen");
    b.ring(map, 0);
    b.edit(map).between = between;
    b.compute("look", {{"src", map, Access::sampled_read, {}, kNoId},
                       {"dst", seen, Access::storage_write, {}, kNoId}});
    b.compute("make", {{"dst", map, Access::storage_write, {}, kNoId}});
    read_back(b, "out", seen);
    return compiled(b);
}

TEST(ExportBarriers, TheFrameLeavesTheImageInTheLayoutOfTheProgram) {
    const AccessState copied{stage::kCopy, access::kTransferRead, Layout::transfer_src};
    const FramePlan plan = with_read_between(copied);
    const std::vector<BarrierDecl> last = barriers_on(plan, plan.barriers.epilogue, "map");
    ASSERT_EQ(last.size(), 1u);
    EXPECT_EQ(last[0].reason, BarrierReason::release_import);
    EXPECT_EQ(last[0].from, pass_id(plan, "make"));
    expect_state(last[0].src, {stage::kComputeShader, access::kStorageWrite, Layout::general});
    expect_state(last[0].dst, copied);
    const BarrierDecl first = barrier_before(plan, "look", "map");
    EXPECT_TRUE(first.from_previous_frame);
    EXPECT_EQ(first.from, kNoId);
    expect_state(first.src, {stage::kCopy, access::kNone, Layout::transfer_src});
    expect_state(first.dst, {stage::kComputeShader, access::kSampledRead, Layout::shader_read_only});
    const std::vector<BarrierDecl> prologue = barriers_on(plan, plan.barriers.prologue.after, "map");
    ASSERT_EQ(prologue.size(), 1u);
    EXPECT_EQ(prologue[0].dst.layout, Layout::transfer_src);
    EXPECT_EQ(plan.boundary[0].state.layout, Layout::transfer_src);
}

TEST(ExportBarriers, AWriteWaitsForTheProgramAndForThePassThatReadsLikeIt) {
    constexpr StageMask kShaders = stage::kComputeShader | stage::kFragmentShader;
    const AccessState sampled{kShaders, access::kSampledRead, Layout::shader_read_only};
    const FramePlan plan = with_read_between(sampled);
    EXPECT_TRUE(barriers_before(plan, "look", "map").empty())
        << "the barrier for the program covers the pass";
    const BarrierDecl write = barrier_before(plan, "make", "map");
    EXPECT_EQ(write.from, kNoId) << "the write also waits for the program, not only for \"look\"";
    expect_state(write.src, {kShaders, access::kNone, Layout::shader_read_only});
}

}  // namespace
}  // namespace weft::test

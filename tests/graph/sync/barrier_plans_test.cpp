// Tests that compile() emits the barrier that each hazard of a frame needs (read after write, write after
// read, write after write, layout change), and no other barrier.
#include <gtest/gtest.h>

#include "tests/graph/compile/plan_expectations.h"

namespace weft::test {
namespace {

constexpr StageMask kDepthTests = stage::kEarlyFragmentTests | stage::kLateFragmentTests;

BuilderUse sampled(ResourceId r, std::optional<SubresourceRange> range = {}) {
    return {"src", r, Access::sampled_read, range, kNoId};
}
BuilderUse stored(ResourceId r, std::optional<SubresourceRange> range = {}) {
    return {"dst", r, Access::storage_write, range, kNoId};
}
BuilderUse words(ResourceId r) {
    return {"words", r, Access::storage_read, {}, kNoId};
}

TEST(BarrierPlans, ReadAfterWriteFromComputeToFragment) {
    GraphBuilder b;
    const ResourceId image = b.image("image"), color = b.image("color");
    b.compute("make", {stored(image)});
    b.pass("draw", PassKind::fullscreen, {sampled(image), {"color", color, Access::color_write, {}, kNoId}});
    read_back(b, "out", color);
    const FramePlan plan = compiled(b);

    const BarrierDecl raw = barrier_before(plan, "draw", "image");
    EXPECT_EQ(raw.reason, BarrierReason::raw);
    EXPECT_EQ(raw.from, pass_id(plan, "make"));
    EXPECT_EQ(raw.to, pass_id(plan, "draw"));
    expect_state(raw.src, {stage::kComputeShader, access::kStorageWrite, Layout::general});
    expect_state(raw.dst, {stage::kFragmentShader, access::kSampledRead, Layout::shader_read_only});
    // There are four barriers. Before `make`: `image` takes over its memory. Before `draw`: one for the read
    // of `image`, and one because `color` takes over its memory. Before `out`: one for the read of `color`.
    EXPECT_EQ(plan.barriers.emitted, 4u);
}

TEST(BarrierPlans, WriteAfterReadWaitsWithoutFlushing) {
    GraphBuilder b;
    const ResourceId x = b.buffer("x"), y = b.buffer("y");
    b.pass("write", PassKind::clear, {{"dst", x, Access::clear_write, {}, kNoId}});
    b.compute("read", {words(x), stored(y)});
    b.pass("overwrite", PassKind::clear, {{"dst", x, Access::clear_write, {}, kNoId}});
    read_back(b, "out_x", x);
    read_back(b, "out_y", y);
    const FramePlan plan = compiled(b);

    const BarrierDecl war = barrier_before(plan, "overwrite", "x");
    EXPECT_EQ(war.reason, BarrierReason::war);
    EXPECT_EQ(war.from, pass_id(plan, "read"));
    expect_state(war.src, {stage::kComputeShader, access::kNone, Layout::undefined});
    expect_state(war.dst, {stage::kClear | stage::kCopy, access::kTransferWrite, Layout::undefined});
}

TEST(BarrierPlans, WriteAfterWriteFlushes) {
    GraphBuilder b;
    const ResourceId x = b.buffer("x");
    b.pass("write", PassKind::clear, {{"dst", x, Access::clear_write, {}, kNoId}}).side_effect = true;
    b.compute("overwrite", {stored(x)});
    read_back(b, "out", x);
    const FramePlan plan = compiled(b);

    const BarrierDecl waw = barrier_before(plan, "overwrite", "x");
    EXPECT_EQ(waw.reason, BarrierReason::waw);
    expect_state(waw.src, {stage::kClear | stage::kCopy, access::kTransferWrite, Layout::undefined});
    expect_state(waw.dst, {stage::kComputeShader, access::kStorageWrite, Layout::undefined});
}

TEST(BarrierPlans, ReadsBetweenTwoWritesShareOneBarrier) {
    GraphBuilder b;
    const ResourceId image = b.image("image"), one = b.buffer("one"), two = b.image("two");
    b.compute("make", {stored(image)});
    b.compute("first", {sampled(image), {"dst", one, Access::storage_write, {}, kNoId}});
    b.pass("second", PassKind::fullscreen, {sampled(image), {"color", two, Access::color_write, {}, kNoId}});
    b.compute("overwrite", {stored(image)}).side_effect = true;
    read_back(b, "out_one", one);
    read_back(b, "out_two", two);
    b.after("first", "second");
    const FramePlan plan = compiled(b);

    const BarrierDecl raw = barrier_before(plan, "first", "image");
    expect_state(raw.dst, {stage::kComputeShader | stage::kFragmentShader, access::kSampledRead,
                           Layout::shader_read_only});
    EXPECT_TRUE(barriers_before(plan, "second", "image").empty());
    const BarrierDecl war = barrier_before(plan, "overwrite", "image");
    expect_state(war.src,
                 {stage::kComputeShader | stage::kFragmentShader, access::kNone, Layout::shader_read_only});
    EXPECT_EQ(war.from, kNoId) << "two passes are waited for";
}

TEST(BarrierPlans, ReadsInAnotherLayoutNeedTheirOwn) {
    GraphBuilder b;
    const ResourceId image = b.image("image"), one = b.buffer("one");
    b.compute("make", {stored(image)});
    b.compute("read", {sampled(image), {"dst", one, Access::storage_write, {}, kNoId}});
    read_back(b, "copy", image);
    read_back(b, "out", one);
    b.after("read", "copy");
    const FramePlan plan = compiled(b);

    EXPECT_EQ(barrier_before(plan, "read", "image").dst.stages, stage::kComputeShader);
    const BarrierDecl layout = barrier_before(plan, "copy", "image");
    EXPECT_EQ(layout.reason, BarrierReason::layout);
    expect_state(layout.src, {stage::kComputeShader, access::kNone, Layout::shader_read_only});
    expect_state(layout.dst, {stage::kCopy, access::kTransferRead, Layout::transfer_src});
}

TEST(BarrierPlans, AMipChainMovesOneMipAtATime) {
    GraphBuilder b;
    const ResourceId chain = b.image("chain", Format::r32u, 16, 3), color = b.image("color");
    b.compute("mip0", {stored(chain, one_cell(0))});
    b.compute("mip1", {sampled(chain, one_cell(0)), stored(chain, one_cell(1))});
    b.compute("mip2", {sampled(chain, one_cell(1)), stored(chain, one_cell(2))});
    b.pass("draw", PassKind::fullscreen, {sampled(chain), {"color", color, Access::color_write, {}, kNoId}});
    read_back(b, "out", color);
    const FramePlan plan = compiled(b);

    const std::vector<BarrierDecl> mip1 = barriers_before(plan, "mip1", "chain");
    ASSERT_EQ(mip1.size(), 2u);
    EXPECT_EQ(mip1[0].reason, BarrierReason::raw);
    EXPECT_EQ(mip1[0].range, one_cell(0));
    EXPECT_EQ(mip1[0].dst.stages, stage::kComputeShader | stage::kFragmentShader) << "serves `draw` as well";
    EXPECT_EQ(mip1[1].reason, BarrierReason::alias);
    EXPECT_EQ(mip1[1].range, one_cell(1));
    const BarrierDecl last = barrier_before(plan, "draw", "chain");
    EXPECT_EQ(last.range, one_cell(2)) << "the other mips are visible already";
    EXPECT_EQ(last.from, pass_id(plan, "mip2"));
}

TEST(BarrierPlans, RangesOfEqualFateAreOne) {
    GraphBuilder b;
    const ResourceId image = b.image("image", Format::r32u, 16, 2, 3), color = b.image("color");
    b.pass("clear", PassKind::clear, {{"dst", image, Access::clear_write, {}, kNoId}});
    b.pass("draw", PassKind::fullscreen, {sampled(image), {"color", color, Access::color_write, {}, kNoId}});
    b.compute("part", {stored(image, one_cell(1, 1))}).side_effect = true;
    read_back(b, "out", color);
    const FramePlan plan = compiled(b);

    EXPECT_EQ(barrier_before(plan, "draw", "image").range,
              plan.graph.resources[find_resource(plan.graph, "image")].whole());
    EXPECT_EQ(barrier_before(plan, "part", "image").range, one_cell(1, 1));
}

TEST(BarrierPlans, DepthWrittenThenSampled) {
    GraphBuilder b;
    const ResourceId z = b.image("z", Format::d32f), lit = b.buffer("lit");
    b.pass("depth", PassKind::raster, {{"depth", z, Access::depth_write, {}, kNoId}});
    b.compute("light", {sampled(z), stored(lit)});
    read_back(b, "out", lit);
    const FramePlan plan = compiled(b);

    const BarrierDecl raw = barrier_before(plan, "light", "z");
    expect_state(raw.src, {kDepthTests, access::kDepthStencilWrite, Layout::depth_attachment});
    expect_state(raw.dst, {stage::kComputeShader, access::kSampledRead, Layout::depth_read_only});
}

TEST(BarrierPlans, DepthTestedAndSampledAtOnceIsOneAccess) {
    GraphBuilder b;
    const ResourceId z = b.image("z", Format::d32f), color = b.image("color");
    b.pass("depth", PassKind::raster, {{"depth", z, Access::depth_write, {}, kNoId}});
    b.pass("draw", PassKind::raster,
           {sampled(z),
            {"color", color, Access::color_write, {}, kNoId},
            {"depth", z, Access::depth_read, {}, kNoId}});
    read_back(b, "out", color);
    const FramePlan plan = compiled(b);

    expect_state(barrier_before(plan, "draw", "z").dst,
                 {kDepthTests | stage::kFragmentShader, access::kSampledRead | access::kDepthStencilRead,
                  Layout::depth_read_only});
    const std::vector<AttachmentOps>& ops = step_of(plan, "draw").attachments;
    EXPECT_EQ(ops[1].load, LoadOp::load);
    EXPECT_EQ(ops[1].store, StoreOp::none);
}

TEST(BarrierPlans, AliasTransitionAndWrapAround) {
    GraphBuilder b;
    const ResourceId a = b.image("a"), mid = b.image("mid"), last = b.image("last");
    b.compute("p1", {stored(a)});
    b.pass("p2", PassKind::fullscreen, {sampled(a), {"color", mid, Access::color_write, {}, kNoId}});
    b.compute("p3", {sampled(mid), stored(last)});
    read_back(b, "p4", last);
    const FramePlan plan = compiled(b);

    // Within the frame, `last` takes over the memory of `a`. The fragment shader of p2 was the last reader of
    // `a`. A read needs no flush, so the source access is kNone.
    const BarrierDecl within = barrier_before(plan, "p3", "last");
    EXPECT_EQ(within.reason, BarrierReason::alias);
    EXPECT_EQ(within.aliased_from, (std::vector<ResourceId>{resource_id(plan, "a")}));
    EXPECT_FALSE(within.from_previous_frame);
    expect_state(within.src, {stage::kFragmentShader, access::kNone, Layout::undefined});
    expect_state(within.dst, {stage::kComputeShader, access::kStorageWrite, Layout::general});
    // At the start of each frame, `a` takes the memory over from `last`. The last use of `last` is the copy
    // in p4 of the frame before.
    const BarrierDecl wrap = barrier_before(plan, "p1", "a");
    EXPECT_EQ(wrap.aliased_from, (std::vector<ResourceId>{resource_id(plan, "last")}));
    EXPECT_TRUE(wrap.from_previous_frame);
    expect_state(wrap.src, {stage::kCopy, access::kNone, Layout::undefined});
    // `mid` shares its memory with no other resource, so it takes the memory over from itself in the previous
    // frame.
    const BarrierDecl self = barrier_before(plan, "p2", "mid");
    EXPECT_EQ(self.aliased_from, (std::vector<ResourceId>{resource_id(plan, "mid")}));
    EXPECT_TRUE(self.from_previous_frame);
    expect_state(self.src, {stage::kComputeShader, access::kNone, Layout::undefined});
}

TEST(BarrierPlans, AnUnreadWriteIsFlushedByTheAliasTransition) {
    GraphBuilder b;
    const ResourceId x = b.buffer("x");
    b.compute("only", {stored(x)}).side_effect = true;
    const FramePlan plan = compiled(b);
    expect_state(barrier_before(plan, "only", "x").src,
                 {stage::kComputeShader, access::kStorageWrite, Layout::undefined});
}

// Returns a plan whose only pass accesses an import as `access` says. `entry` and `exit` are the states of
// the import before and after the frame.
FramePlan with_import(const AccessState& entry, const AccessState& exit, Access access) {
    GraphBuilder b;
    const ResourceId import = b.image("import"), other = b.buffer("other");
    b.import_as(import, entry, exit);
    b.compute("touch",
              {{"import", import, access, {}, kNoId}, {"dst", other, Access::storage_write, {}, kNoId}})
        .side_effect = true;
    return compiled(b);
}

constexpr AccessState kFragmentReads{stage::kFragmentShader, access::kSampledRead, Layout::shader_read_only};

TEST(BarrierPlans, AReadOnlyImportNeedsNothing) {
    const FramePlan plan = with_import(kFragmentReads, kFragmentReads, Access::sampled_read);
    EXPECT_TRUE(barriers_before(plan, "touch", "import").empty());
    EXPECT_TRUE(plan.barriers.epilogue.empty());
}

TEST(BarrierPlans, AnImportIsAcquiredAndReleased) {
    const FramePlan plan = with_import(kFragmentReads, kFragmentReads, Access::storage_write);
    const BarrierDecl acquire = barrier_before(plan, "touch", "import");
    EXPECT_EQ(acquire.reason, BarrierReason::acquire_import);
    EXPECT_EQ(acquire.from, kNoId);
    expect_state(acquire.src, {stage::kFragmentShader, access::kNone, Layout::shader_read_only});
    expect_state(acquire.dst, {stage::kComputeShader, access::kStorageWrite, Layout::general});
    ASSERT_EQ(plan.barriers.epilogue.size(), 1u);
    const BarrierDecl& release = plan.barriers.epilogue.front();
    EXPECT_EQ(release.reason, BarrierReason::release_import);
    expect_state(release.src, {stage::kComputeShader, access::kStorageWrite, Layout::general});
    expect_state(release.dst, kFragmentReads);
    ASSERT_EQ(plan.boundary.size(), 1u);
    expect_state(plan.boundary.front().state, kFragmentReads);
}

TEST(BarrierPlans, APendingWriteIsFlushedBeforeAnImportIsRead) {
    const AccessState written{stage::kCopy, access::kTransferWrite, Layout::shader_read_only};
    const FramePlan plan = with_import(written, written, Access::sampled_read);
    const BarrierDecl acquire = barrier_before(plan, "touch", "import");
    expect_state(acquire.src, written);
    expect_state(acquire.dst, {stage::kComputeShader, access::kSampledRead, Layout::shader_read_only});
    ASSERT_EQ(plan.barriers.epilogue.size(), 1u) << "the next write must wait for this frame's reads";
    expect_state(plan.barriers.epilogue.front().src,
                 {stage::kComputeShader, access::kNone, Layout::shader_read_only});
}

TEST(BarrierPlans, AnImportReadInAnotherLayoutGoesBack) {
    const AccessState general{stage::kComputeShader, access::kStorageRead, Layout::general};
    const FramePlan plan = with_import(general, general, Access::sampled_read);
    EXPECT_EQ(barrier_before(plan, "touch", "import").reason, BarrierReason::acquire_import);
    ASSERT_EQ(plan.barriers.epilogue.size(), 1u);
    expect_state(plan.barriers.epilogue.front().src,
                 {stage::kComputeShader, access::kNone, Layout::shader_read_only});
}

TEST(BarrierPlans, LoadAndStoreOperationsFollowTheReaders) {
    GraphBuilder b;
    const ResourceId color = b.image("color"), extra = b.image("extra"), z = b.image("z", Format::d32f);
    b.pass("base", PassKind::raster,
           {{"color", color, Access::color_write, {}, kNoId},
            {"extra", extra, Access::color_write, {}, kNoId},
            {"depth", z, Access::depth_write, {}, kNoId}});
    b.pass("more", PassKind::raster,
           {{"color", color, Access::color_read_write, {}, kNoId},
            {"depth", z, Access::depth_read_write, {}, kNoId}});
    PassDecl& screen =
        b.pass("screen", PassKind::fullscreen, {{"color", extra, Access::color_write, {}, kNoId}});
    screen.colors.front().covers = true;
    read_back(b, "out", color);
    read_back(b, "out_extra", extra);
    b.after("more", "screen");
    const FramePlan plan = compiled(b);

    const auto expect_ops = [&](const char* pass, size_t index, LoadOp load, StoreOp store) {
        const AttachmentOps& ops = step_of(plan, pass).attachments.at(index);
        EXPECT_EQ(ops.load, load) << pass << " " << index;
        EXPECT_EQ(ops.store, store) << pass << " " << index;
    };
    expect_ops("base", 0, LoadOp::clear, StoreOp::store);
    expect_ops("base", 1, LoadOp::clear, StoreOp::dont_care);
    expect_ops("base", 2, LoadOp::clear, StoreOp::store);
    expect_ops("more", 0, LoadOp::load, StoreOp::store);
    expect_ops("more", 1, LoadOp::load, StoreOp::dont_care);
    expect_ops("screen", 0, LoadOp::dont_care, StoreOp::store);
    // A load or store operation that discards the content counts as a write. `screen` discards the old
    // content of `extra` when it begins, so it must wait for the write of `base` to `extra`. `more` discards
    // `z` when it ends, so `base`, which writes `z` in the next frame, must wait for a write.
    expect_state(barrier_before(plan, "screen", "extra").src,
                 {stage::kColorOutput, access::kColorWrite, Layout::color_attachment});
    EXPECT_TRUE(barrier_before(plan, "base", "z").src.access & access::kDepthStencilWrite);
}

}  // namespace
}  // namespace weft::test

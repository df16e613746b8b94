// Tests the rules of the null executor one at a time, on small plans that are correct before the test changes
// them.
#include "null/null_executor.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/graph/compile/naive_plan.h"
#include "tests/graph/samples/graph_builder.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

constexpr uint64_t kSeeds = 6;

std::vector<std::string> broken(const FramePlan& plan) {
    const NullRun wanted = run_reference(plan.graph, plan.live);
    EXPECT_FALSE(wanted.observed.empty());
    for (uint64_t seed = 0; seed < kSeeds; ++seed) {
        const NullOrder order = seed == 0 ? NullOrder::delayed : NullOrder::shuffled;
        const NullRun found = run_null(plan, {3, seed, order});
        std::vector<std::string> different = differences(plan.graph, wanted, found);
        if (different.empty()) continue;
        different.insert(different.end(), found.faults.begin(), found.faults.end());
        return different;
    }
    return {};
}

// A plan with these passes: "make" writes a, "blur" reads a and writes b, "tint" reads b and writes c, and
// "read_back" reads c. Image c uses the memory that image a used before.
class NullExecutor : public testing::Test {
 protected:
    NullExecutor() {
        GraphBuilder builder;
        const ResourceId a = builder.image("a"), b = builder.image("b"), c = builder.image("c");
        builder.compute("make", {{"dst", a, Access::storage_write}});
        builder.compute("blur", {{"src", a, Access::sampled_read}, {"dst", b, Access::storage_write}});
        builder.compute("tint", {{"src", b, Access::sampled_read}, {"dst", c, Access::storage_write}});
        builder.pass("read_back", PassKind::readback, {{"src", c, Access::copy_read}});
        const ResolvedGraph graph = builder.build();
        plan = compile(graph, content_needs(graph), {});
    }

    PassStep& step(const char* name) {
        return *std::find_if(
            plan.barriers.steps.begin(), plan.barriers.steps.end(),
            [pass = find_pass(plan.graph, name)](const PassStep& s) { return s.pass == pass; });
    }
    BarrierDecl& barrier(const char* pass, const char* resource) {
        for (BarrierDecl& b : step(pass).barriers)
            if (plan.graph.resources[b.resource].name == resource) return b;
        ADD_FAILURE() << "no barrier before " << pass << " on " << resource;
        return step(pass).barriers.front();
    }

    // Moves "make" and "blur" to a second queue, of the queue family `family`. "tint" and "read_back" wait
    // for them. "make" and "blur" wait for "tint" and "read_back" of the previous frame.
    void use_two_queues(uint32_t family) {
        plan.schedule.queues = {{QueueKind::graphics, 0}, {QueueKind::compute, family}};
        plan.schedule.queue = {1, 1, 0, 0};
        Batch first, second;
        first.queue = 1;
        first.positions = {0, 1};
        first.waits = {{1, true, kNoId}};
        second.positions = {2, 3};
        second.waits = {{0, false, kNoId}};
        second.epilogue = true;
        plan.submissions.batches = {first, second};
        plan.barriers.concurrent.assign(plan.graph.resources.size(), 1);
        for (PassStep& s : plan.barriers.steps)
            for (BarrierDecl& b : s.barriers) b.src.stages |= b.dst.stages;
    }

    FramePlan plan;
};

TEST_F(NullExecutor, RunsASoundPlanAsDeclared) {
    EXPECT_TRUE(broken(plan).empty()) << broken(plan).back();
    ASSERT_EQ(plan.memory.placements.size(), 3u);
}

TEST_F(NullExecutor, SeesADroppedBarrier) {
    step("blur").barriers.clear();
    EXPECT_FALSE(broken(plan).empty());
}

TEST_F(NullExecutor, SeesAWriteThatIsNotAvailable) {
    barrier("blur", "a").src.access = access::kNone;
    EXPECT_FALSE(broken(plan).empty());
}

TEST_F(NullExecutor, SeesAReadThatNothingIsVisibleTo) {
    barrier("blur", "a").dst.access = access::kStorageRead;
    EXPECT_FALSE(broken(plan).empty());
}

TEST_F(NullExecutor, SeesAStageThatIsNotWaitedFor) {
    barrier("read_back", "c").src.stages = stage::kFragmentShader;
    EXPECT_FALSE(broken(plan).empty());
}

TEST_F(NullExecutor, SeesAStageThatDoesNotWait) {
    barrier("read_back", "c").dst.stages = stage::kClear;
    EXPECT_FALSE(broken(plan).empty());
}

TEST_F(NullExecutor, SeesTheWrongLayout) {
    barrier("blur", "a").dst.layout = Layout::general;
    EXPECT_FALSE(broken(plan).empty());
}

TEST_F(NullExecutor, SeesMemoryTakenTooEarly) {
    barrier("tint", "c").aliased_from.clear();
    barrier("tint", "c").src = {stage::kCopy, access::kNone, Layout::undefined};
    EXPECT_FALSE(broken(plan).empty());
}

TEST_F(NullExecutor, SeesMemoryTakenWhileItIsNeeded) {
    for (Placement& p : plan.memory.placements) p = {p.resource, 0, 0, p.size_bytes};
    EXPECT_FALSE(broken(plan).empty());
}

TEST_F(NullExecutor, SeesAForgottenPass) {
    plan.submissions.batches.front().positions.pop_back();
    EXPECT_FALSE(broken(plan).empty());
}

TEST_F(NullExecutor, QueuesAreOrderedByWaitsAlone) {
    use_two_queues(0);
    EXPECT_TRUE(broken(plan).empty()) << broken(plan).back();
    const FramePlan sound = plan;
    plan.submissions.batches[1].waits.clear();
    EXPECT_FALSE(broken(plan).empty());
    plan = sound;
    plan.submissions.batches[0].waits.clear();
    EXPECT_FALSE(broken(plan).empty()) << "the next frame's writes don't wait for this one's reads";
}

TEST_F(NullExecutor, ExclusiveImagesChangeFamilyInPairs) {
    use_two_queues(1);
    EXPECT_TRUE(broken(plan).empty()) << broken(plan).back();
    std::fill(plan.barriers.concurrent.begin(), plan.barriers.concurrent.end(), uint8_t{0});
    EXPECT_FALSE(broken(plan).empty());
    BarrierDecl& acquire = barrier("tint", "b");
    acquire.src_family = 1;
    acquire.reason = BarrierReason::acquire_queue;
    EXPECT_FALSE(broken(plan).empty()) << "nobody has released it";
    BarrierDecl release = acquire;
    release.reason = BarrierReason::release_queue;
    release.src = {stage::kComputeShader, access::kStorageWrite, Layout::general};
    step("blur").after.push_back(release);
    EXPECT_TRUE(broken(plan).empty()) << broken(plan).back();
    step("blur").after.front().dst.layout = Layout::general;
    EXPECT_FALSE(broken(plan).empty()) << "the halves do not match";
}

TEST(NullImports, KeepWhatWasWrittenAndShowIt) {
    GraphBuilder builder;
    const ResourceId words = builder.buffer("words"), state = builder.buffer("state");
    const AccessState kept{stage::kComputeShader, access::kStorageRead | access::kStorageWrite};
    builder.import_as(state, kept, kept);
    builder.compute("make", {{"dst", words, Access::storage_write}});
    builder
        .compute("update", {{"src", words, Access::storage_read}, {"dst", state, Access::storage_read_write}})
        .side_effect = true;
    const ResolvedGraph graph = builder.build();
    FramePlan plan = compile(graph, content_needs(graph), {});
    EXPECT_TRUE(broken(plan).empty()) << broken(plan).back();
    const NullRun run = run_null(plan);
    std::vector<CellValue> values;
    for (const ObservedCell& cell : run.observed)
        if (cell.pass == kNoId) values.push_back(cell.value);
    ASSERT_EQ(values.size(), 3u);
    EXPECT_NE(values[0], values[1]);
    EXPECT_NE(values[1], values[2]);
    plan.barriers.epilogue.clear();
    EXPECT_FALSE(broken(plan).empty());
}

// A graph in which pass "draw" writes a multisampled image, and also the image that the samples are resolved
// to.
class NullResolve : public testing::Test {
 protected:
    NullResolve() {
        GraphBuilder builder;
        const ResourceId many = builder.image("many"), one = builder.image("one"),
                         copy = builder.image("copy");
        builder.edit(many).samples = 4;
        PassDecl& draw =
            builder.pass("draw", PassKind::raster,
                         {{"color", many, Access::color_write}, {"one", one, Access::color_write}});
        draw.colors.pop_back();
        draw.colors[0].resolve_use = 1;
        builder.compute("use", {{"src", one, Access::sampled_read}, {"dst", copy, Access::storage_write}});
        builder.pass("read_back", PassKind::readback, {{"src", copy, Access::copy_read}});
        graph = builder.build();
    }

    ResolvedGraph graph;
};

TEST_F(NullResolve, TheTargetIsWrittenByThePass) {
    FramePlan plan = compile(graph, content_needs(graph), {});
    EXPECT_TRUE(broken(plan).empty()) << broken(plan).back();
    EXPECT_TRUE(broken(naive_plan(graph)).empty());
    for (const AttachmentOps& ops : plan.barriers.steps[0].attachments)
        EXPECT_EQ(ops.store, StoreOp::dont_care) << "nobody reads the samples themselves";
    ASSERT_EQ(plan.graph.passes[plan.barriers.steps[1].pass].name, "use");
    std::erase_if(plan.barriers.steps[1].barriers,
                  [&](const BarrierDecl& b) { return plan.graph.resources[b.resource].name == "one"; });
    EXPECT_FALSE(broken(plan).empty());
}

// Returns a plan in which pass "second" draws on the result of pass "first". If `looks` is true, "second"
// also reads the buffer that "first" wrote.
FramePlan drawing(bool looks) {
    GraphBuilder b;
    const ResourceId target = b.image("target"), words = b.buffer("words");
    b.pass("first", PassKind::fullscreen,
           {{"words", words, Access::storage_write}, {"color", target, Access::color_write}});
    std::vector<BuilderUse> uses{{"color", target, Access::color_read_write}};
    if (looks) uses.push_back({"words", words, Access::storage_read});
    b.pass("second", PassKind::fullscreen, uses);
    b.pass("read_back", PassKind::readback, {{"src", target, Access::copy_read}});
    b.pass("read_words", PassKind::readback, {{"src", words, Access::copy_read}});
    const ResolvedGraph graph = b.build();
    return compile(graph, content_needs(graph), {});
}

TEST(NullScopes, OrderWhatIsDrawn) {
    FramePlan plan = drawing(false);
    PassStep& second = plan.barriers.steps[1];
    ASSERT_TRUE(second.merges_render_pass);
    EXPECT_TRUE(broken(plan).empty());
    second.merges_render_pass = false;
    EXPECT_FALSE(broken(plan).empty());
}

TEST(NullScopes, OrderNothingElse) {
    FramePlan plan = drawing(true);
    PassStep& second = plan.barriers.steps[1];
    ASSERT_EQ(second.barriers.size(), 2u);
    EXPECT_TRUE(broken(plan).empty());
    second.barriers.clear();
    second.merges_render_pass = true;
    EXPECT_FALSE(broken(plan).empty());
}

}  // namespace
}  // namespace weft::test

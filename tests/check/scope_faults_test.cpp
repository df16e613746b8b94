// Two passes draw on the same attachments in one rendering scope. Each test breaks the plan in one way, and
// the checker must report an error.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/graph/samples/graph_builder.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

class ScopeFault : public testing::Test {
 protected:
    ScopeFault() {
        GraphBuilder b;
        const ResourceId target = b.image("target", Format::rgba16f), z = b.image("z", Format::d32f);
        const ResourceId input = b.image("input", Format::rgba16f);
        b.compute("make", {{"dst", input, Access::storage_write, {}, kNoId}});
        b.pass("first", PassKind::raster,
               {{"src", input, Access::sampled_read, {}, 0},
                {"color", target, Access::color_write, {}, kNoId},
                {"depth", z, Access::depth_write, {}, kNoId}});
        b.pass("second", PassKind::raster,
               {{"src", input, Access::sampled_read, {}, 0},
                {"color", target, Access::color_read_write, {}, kNoId},
                {"depth", z, Access::depth_read_write, {}, kNoId}});
        b.pass("read", PassKind::readback, {{"src", target, Access::copy_read, {}, kNoId}});
        const ResolvedGraph graph = b.build();
        plan = compile(graph, content_needs(graph, 1), {});
    }

    Position position(const char* name) const { return plan.schedule.position[find_pass(plan.graph, name)]; }
    PassStep& step(const char* name) { return plan.barriers.steps[position(name)]; }
    PassDecl& pass(const char* name) { return plan.graph.passes[step(name).pass]; }
    UseDecl& use(const char* name, const char* port) {
        std::vector<UseDecl>& uses = pass(name).uses;
        return *std::find_if(uses.begin(), uses.end(), [port](const UseDecl& u) { return u.port == port; });
    }

    // Expects that at least one error with this code names both passes and contains `what`.
    void expect_fault(const char* code, const std::string& what) {
        const Diagnostics faults = check_plan(plan);
        const bool found = std::any_of(faults.begin(), faults.end(), [&](const Diagnostic& d) {
            const auto says = [&](const std::string& text) {
                return d.message.find(text) != std::string::npos;
            };
            return d.code == code && says("\"second\"") && says("\"first\"") && says(what);
        });
        EXPECT_TRUE(found) << (faults.empty() ? "no fault was found" : to_text(faults));
    }

    FramePlan plan;
};

TEST_F(ScopeFault, NoneInTheSoundPlan) {
    ASSERT_TRUE(step("second").merges_render_pass);
    ASSERT_TRUE(step("second").barriers.empty());
    const Diagnostics faults = check_plan(plan);
    EXPECT_TRUE(faults.empty()) << to_text(faults);
}

// If "second" has a rendering scope of its own, it needs two barriers, which the plan does not have.
TEST_F(ScopeFault, ScopeDropped) {
    step("second").merges_render_pass = false;
    expect_fault("C310", "\"target\"");
    expect_fault("C310", "\"z\"");
}

TEST_F(ScopeFault, BarrierInBetween) {
    BarrierDecl barrier;
    barrier.resource = use("second", "src").resource;
    barrier.src = barrier.dst = use("second", "src").state;
    step("second").barriers = {barrier};
    expect_fault("C306", "barriers");
    step("second").barriers.clear();
    step("first").after = {barrier};
    expect_fault("C306", "barriers");
}

TEST_F(ScopeFault, AnotherKindOfPass) {
    pass("first").kind = PassKind::custom;
    expect_fault("C306", "draw");
}

TEST_F(ScopeFault, AnotherExtent) {
    pass("second").render_extent.height /= 2;
    expect_fault("C306", "extents");
}

TEST_F(ScopeFault, OtherAttachments) {
    use("second", "color").range.layers = 2;
    expect_fault("C306", "attachments");
}

TEST_F(ScopeFault, FewerAttachments) {
    pass("second").depth.reset();
    expect_fault("C306", "attachments");
}

TEST_F(ScopeFault, AnotherDepthLayout) {
    use("second", "depth").access = Access::depth_read;
    use("second", "depth").state = access_state(Access::depth_read, 0, aspect::kDepth);
    expect_fault("C306", "layouts");
}

TEST_F(ScopeFault, ClearedInBetween) {
    step("second").attachments.front().load = LoadOp::clear;
    expect_fault("C306", "\"target\"");
}

TEST_F(ScopeFault, NotDrawnOver) {
    use("second", "color").access = Access::color_write;
    expect_fault("C306", "\"target\"");
}

TEST_F(ScopeFault, ResolvedInBetween) {
    pass("first").colors.front().resolve_use = 0;
    expect_fault("C306", "resolved");
}

TEST_F(ScopeFault, StoredByNobody) {
    step("second").attachments.front().store = StoreOp::dont_care;
    const Diagnostics faults = check_plan(plan);
    ASSERT_FALSE(faults.empty());
    EXPECT_EQ(faults.front().code, "C330");
}

// The store operation of "first" has no effect, because only the last pass of a rendering scope stores the
// attachments.
TEST_F(ScopeFault, NoneWhereTheFirstPassStoresNothing) {
    step("first").attachments.front().store = StoreOp::dont_care;
    const Diagnostics faults = check_plan(plan);
    EXPECT_TRUE(faults.empty()) << to_text(faults);
}

// Inside a rendering scope only attachment accesses are ordered. A texture read of the drawn image is not.
TEST_F(ScopeFault, SamplingWhatTheScopeDraws) {
    UseDecl& sampled = use("second", "src");
    sampled.resource = use("second", "color").resource;
    sampled.sources = use("second", "color").sources;
    expect_fault("C306", "in other ways than as an attachment");
    expect_fault("C310", "\"target\"");
}

TEST_F(ScopeFault, FirstPassOfItsSubmission) {
    const uint32_t second = position("second");
    std::vector<Batch>& batches = plan.submissions.batches;
    ASSERT_EQ(batches.size(), 1u);
    Batch later = batches.front();
    std::erase_if(batches.front().positions, [&](uint32_t p) { return p >= second; });
    std::erase_if(later.positions, [&](uint32_t p) { return p < second; });
    batches.front().epilogue = false;
    batches.push_back(later);
    const Diagnostics faults = check_plan(plan);
    EXPECT_TRUE(
        std::any_of(faults.begin(), faults.end(), [](const Diagnostic& d) { return d.code == "C306"; }));
}

}  // namespace
}  // namespace weft::test

// Tests which passes share a rendering scope: passes that draw on the same attachments share one if no
// barrier is needed between them.
#include "graph/sync/scopes.h"

#include <gtest/gtest.h>

#include "tests/graph/compile/plan_expectations.h"
#include "weft/report/plan_dump.h"
#include "weft/report/plan_explain.h"

namespace weft::test {
namespace {

constexpr uint32_t kSide = 16;

// Builds a graph for these tests. Pass "make" writes `input`. Pass "first" and all passes added by draw()
// read `input` and draw on `target`. Pass "read" reads `target`.
class Layers {
 public:
    explicit Layers(Format format = Format::rgba16f)
        : target(builder.image("target", format, kSide)), input(builder.image("input", format, kSide)) {
        builder.compute("make", {{"dst", input, Access::storage_write, {}, kNoId}});
        add("first", Access::color_write, {});
    }

    PassDecl& draw(const char* name, std::vector<BuilderUse> more = {}) {
        return add(name, Access::color_read_write, std::move(more));
    }
    FramePlan plan() {
        read_back(builder, "read", target);
        return compiled(builder);
    }

    GraphBuilder builder;
    ResourceId target, input;

 private:
    PassDecl& add(const char* name, Access access, std::vector<BuilderUse> more) {
        more.push_back({"src", input, Access::sampled_read, {}, 0});
        more.push_back({"color", target, access, {}, kNoId});
        return builder.pass(name, PassKind::fullscreen, more);
    }
};

bool merged(const FramePlan& plan, const char* pass) {
    return step_of(plan, pass).merges_render_pass;
}

// Expects that the pass begins a rendering scope of its own and has a barrier that waits for the earlier
// drawing.
void expect_apart(const FramePlan& plan, const char* pass) {
    EXPECT_FALSE(merged(plan, pass));
    EXPECT_FALSE(barriers_before(plan, pass, "target").empty());
}

TEST(ScopePlans, ThreePassesOverOneTargetAreOneScopeWithoutBarriers) {
    Layers layers;
    layers.draw("second");
    layers.draw("third");
    const FramePlan plan = layers.plan();
    EXPECT_FALSE(merged(plan, "first"));
    for (const char* pass : {"second", "third"}) {
        EXPECT_TRUE(merged(plan, pass));
        EXPECT_TRUE(step_of(plan, pass).barriers.empty()) << pass;
    }
    // There are four barriers: one before `make`, two before `first` (for `target` and `input`), one before
    // `read`, and none between the three draws.
    EXPECT_EQ(plan.barriers.emitted, 4u);
    const BarrierDecl after = barrier_before(plan, "read", "target");
    expect_state(after.src, {stage::kColorOutput, access::kColorWrite, Layout::color_attachment});
    EXPECT_EQ(after.from, pass_id(plan, "third"));
}

TEST(ScopePlans, WhatTheFirstPassDrewIsSampledInBetween) {
    Layers layers;
    const ResourceId copy = layers.builder.image("copy", Format::rgba16f, kSide);
    layers.builder.pass("look", PassKind::fullscreen,
                        {{"src", layers.target, Access::sampled_read, {}, 0},
                         {"color", copy, Access::color_write, {}, kNoId}});
    layers.draw("second");
    read_back(layers.builder, "read_copy", copy);
    expect_apart(layers.plan(), "second");
}

TEST(ScopePlans, SomethingElseHasToBeWaitedFor) {
    Layers layers;
    const ResourceId words = layers.builder.buffer("words");
    layers.builder.compute("fill", {{"dst", words, Access::storage_write, {}, kNoId}});
    layers.builder.after("fill", "first");
    layers.draw("second", {{"words", words, Access::storage_read, {}, 1}});
    const FramePlan plan = layers.plan();
    expect_apart(plan, "second");
    EXPECT_EQ(barriers_before(plan, "second", "words").size(), 1u);
}

TEST(ScopePlans, AnotherExtent) {
    Layers layers;
    layers.draw("second").render_extent.width /= 2;
    expect_apart(layers.plan(), "second");
}

TEST(ScopePlans, AClearBeginsAnother) {
    Layers layers;
    layers.builder.pass("second", PassKind::fullscreen,
                        {{"src", layers.input, Access::sampled_read, {}, 0},
                         {"color", layers.target, Access::color_write, {}, kNoId}});
    read_back(layers.builder, "read", layers.target);
    const ResolvedGraph graph = layers.builder.build();
    CompileOptions options;
    // Without this option pass "first" would be culled, because no other pass reads its output.
    options.keep_all_passes = true;
    const FramePlan plan = compile(graph, content_needs(graph, 1), options);
    EXPECT_TRUE(check_plan(plan).empty()) << to_text(check_plan(plan));
    expect_apart(plan, "second");
}

TEST(ScopePlans, AnotherMip) {
    GraphBuilder b;
    const ResourceId target = b.image("target", Format::rgba16f, kSide, 2);
    for (uint32_t mip = 0; mip < 2; ++mip)
        b.pass("first" + std::to_string(mip), PassKind::fullscreen,
               {{"color", target, Access::color_write, one_cell(mip), kNoId}});
    for (uint32_t mip = 0; mip < 2; ++mip)
        b.pass("second" + std::to_string(mip), PassKind::fullscreen,
               {{"color", target, Access::color_read_write, one_cell(mip), kNoId}});
    read_back(b, "read", target);
    const FramePlan plan = compiled(b);
    for (const PassStep& step : plan.barriers.steps)
        if (step.merges_render_pass) {
            const Position position = plan.schedule.position[step.pass];
            const std::string& name = plan.graph.passes[step.pass].name;
            const std::string& before = plan.graph.passes[plan.schedule.order[position - 1]].name;
            EXPECT_EQ(name.back(), before.back()) << name << " goes on after " << before;
        }
}

TEST(ScopePlans, AMultisampledTargetThatIsResolvedInBetween) {
    for (const bool first : {true, false}) {
        Layers layers;
        layers.draw("second");
        read_back(layers.builder, "read", layers.target);
        ResolvedGraph graph = layers.builder.build();
        PassDecl& pass = graph.passes[find_pass(graph, first ? "first" : "second")];
        pass.colors.front().resolve_use = 0;
        const FramePlan plan = compile(graph, content_needs(graph, 1), {});
        EXPECT_FALSE(merged(plan, "second"));
    }
}

// Returns a plan in which the passes "first" and "second" use the same depth attachment, with the accesses
// `first` and `second`. If `first` only reads the depth, a pass before it writes the depth.
FramePlan depth_pair(Access first, Access second) {
    GraphBuilder b;
    const ResourceId target = b.image("target", Format::rgba16f, kSide);
    const ResourceId z = b.image("z", Format::d32f, kSide);
    if (first == Access::depth_read)
        b.pass("prepass", PassKind::raster, {{"depth", z, Access::depth_write, {}, kNoId}});
    b.pass("first", PassKind::raster,
           {{"color", target, Access::color_write, {}, kNoId}, {"depth", z, first, {}, kNoId}});
    b.pass("second", PassKind::raster,
           {{"color", target, Access::color_read_write, {}, kNoId}, {"depth", z, second, {}, kNoId}});
    read_back(b, "read", target);
    return compiled(b);
}

TEST(ScopePlans, DepthTestedPassesMergeWhereTheLayoutStays) {
    EXPECT_TRUE(merged(depth_pair(Access::depth_write, Access::depth_read_write), "second"));
    EXPECT_TRUE(merged(depth_pair(Access::depth_read, Access::depth_read), "second"));
    expect_apart(depth_pair(Access::depth_write, Access::depth_read), "second");
}

TEST(ScopePlans, WhoeverComesNextWaitsForDepthToo) {
    GraphBuilder b;
    const ResourceId z = b.image("z", Format::d32f, kSide);
    b.pass("first", PassKind::raster, {{"depth", z, Access::depth_write, {}, kNoId}});
    b.pass("second", PassKind::raster, {{"depth", z, Access::depth_read_write, {}, kNoId}});
    const ResourceId out = b.image("out");
    b.compute("look",
              {{"z", z, Access::sampled_read, {}, 0}, {"dst", out, Access::storage_write, {}, kNoId}});
    read_back(b, "read", out);
    const FramePlan plan = compiled(b);
    ASSERT_TRUE(merged(plan, "second"));
    const BarrierDecl after = barrier_before(plan, "look", "z");
    EXPECT_EQ(after.src.stages, stage::kEarlyFragmentTests | stage::kLateFragmentTests);
    EXPECT_EQ(after.src.access, access::kDepthStencilWrite);
    EXPECT_EQ(after.from, pass_id(plan, "second"));
}

// Pass "look" on another queue reads the output of pass "first". So pass "second" must wait for "look" before
// it draws, and cannot share the scope of "first".
TEST(ScopePlans, NotAcrossASemaphore) {
    GraphBuilder b;
    const ResourceId target = b.image("target", Format::r32u, kSide),
                     out = b.image("out", Format::r32u, kSide);
    b.pass("first", PassKind::fullscreen, {{"color", target, Access::color_write, {}, kNoId}});
    b.compute("look",
              {{"src", target, Access::sampled_read, {}, 0}, {"dst", out, Access::storage_write, {}, kNoId}})
        .queue = QueueKind::compute;
    b.pass("second", PassKind::fullscreen, {{"color", target, Access::color_read_write, {}, kNoId}});
    read_back(b, "read", target);
    read_back(b, "read_out", out);
    const ResolvedGraph graph = b.build();
    CompileOptions options;
    options.queues = {{QueueKind::graphics, 0}, {QueueKind::compute, 0}};
    const FramePlan plan = compile(graph, content_needs(graph, 1), options);
    EXPECT_TRUE(check_plan(plan).empty()) << to_text(check_plan(plan));
    ASSERT_EQ(plan.schedule.queue[plan.schedule.position[pass_id(plan, "look")]], 1u);
    EXPECT_FALSE(merged(plan, "second"));
}

// No barrier or other command is needed between passes "first" and "second". But if another queue waits for
// "first", a semaphore signal ends the submission after "first", so "second" needs its own scope.
TEST(ScopePlans, NotBehindASignal) {
    for (const bool waits : {false, true}) {
        GraphBuilder b;
        const ResourceId target = b.image("target", Format::r32u, kSide), words = b.buffer("words");
        const ResourceId copy = b.buffer("copy");
        b.pass("first", PassKind::fullscreen,
               {{"words", words, Access::storage_write, {}, 0},
                {"color", target, Access::color_write, {}, kNoId}});
        b.compute("look", {{"src", words, Access::storage_read, {}, 0},
                           {"dst", copy, Access::storage_write, {}, kNoId}})
            .queue = waits ? QueueKind::compute : QueueKind::graphics;
        b.pass("second", PassKind::fullscreen, {{"color", target, Access::color_read_write, {}, kNoId}});
        if (!waits) b.after("second", "look");
        read_back(b, "read", target);
        read_back(b, "read_copy", copy);
        const ResolvedGraph graph = b.build();
        CompileOptions options;
        options.queues = {{QueueKind::graphics, 0}, {QueueKind::compute, 0}};
        const FramePlan plan = compile(graph, content_needs(graph, 1), options);
        EXPECT_TRUE(check_plan(plan).empty()) << to_text(check_plan(plan));
        EXPECT_EQ(merged(plan, "second"), !waits);
        EXPECT_EQ(barriers_before(plan, "second", "target").size(), waits ? 1u : 0u);
    }
}

TEST(ScopePlans, DumpsAndAnswersSayIt) {
    Layers layers;
    layers.draw("second");
    const FramePlan plan = layers.plan();
    EXPECT_NE(plan_to_text(plan).find("    continues the rendering scope of pass first\n"),
              std::string::npos);
    EXPECT_NE(plan_to_json(plan).find("\"mergesRenderPass\": true"), std::string::npos);
    EXPECT_NE(plan_to_dot(plan).find("one rendering scope"), std::string::npos);
    const Result<std::string> answer = explain_barrier(plan, "first", "second");
    ASSERT_TRUE(answer.ok());
    EXPECT_NE(answer->find("one rendering scope"), std::string::npos) << *answer;
}

}  // namespace
}  // namespace weft::test

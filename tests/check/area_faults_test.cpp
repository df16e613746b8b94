// Most tests break the areas of a correct plan in one way; the checker must report C351. The others are about
// transitions between plans with and without live sizes.
#include <algorithm>

#include "graph/schedule/queue_assign.h"
#include "tests/graph/resolve/live/live_fixture.h"
#include "weft/check/check_plan.h"
#include "weft/check/check_transition.h"
#include "weft/compile.h"
#include "weft/transition.h"

namespace weft::test {
namespace {

class AreaFault : public LiveTest {
 protected:
    AreaFault() {
        const ResolvedGraph graph =
            good(body(R"j(, "state": {"scissor": [0, 0, "render.x", "floor(render.y / 2)"]})j"));
        plan = compile(graph, content_needs(graph), {});
    }
    bool has_fault() {
        const Diagnostics faults = check_plan(plan);
        return std::ranges::any_of(faults, [](const Diagnostic& d) { return d.code == "C351"; });
    }
    PassDecl& pass(const char* name) { return plan.graph.passes[find_pass(plan.graph, name)]; }
    ResourceDecl& image(const char* name) { return plan.graph.resources[find_resource(plan.graph, name)]; }
    ParamWrite& member(const char* of, const char* name) {
        return *std::ranges::find(pass(of).params, name, &ParamWrite::member);
    }

    FramePlan plan;
};

TEST_F(AreaFault, TheSoundPlanHasNone) {
    EXPECT_TRUE(check_plan(plan).empty()) << to_text(check_plan(plan));
}

TEST_F(AreaFault, AnotherExtentThanTheAreaAtScaleOne) {
    image("color").extent.width -= 1;
    EXPECT_TRUE(has_fault());
}

TEST_F(AreaFault, TheAreaOfAnotherSize) {
    image("color").area = image("low").area;
    EXPECT_TRUE(has_fault());
}

TEST_F(AreaFault, ACopyOfTheRingWithoutAnArea) {
    image("past[-1]").area = kNoId;
    EXPECT_TRUE(has_fault());
}

TEST_F(AreaFault, AnAreaOfAnImport) {
    image("backbuffer").area = image("color").area;
    EXPECT_TRUE(has_fault());
}

TEST_F(AreaFault, AnAreaOfAnImageThatKeepsItsContent) {
    image("past").history = 0;
    EXPECT_TRUE(has_fault());
}

TEST_F(AreaFault, APassWithoutTheAreaOfItsAttachment) {
    pass("paint").area = {};
    EXPECT_TRUE(has_fault());
}

TEST_F(AreaFault, ACopyBetweenDifferentAreas) {
    image("other").area = kNoId;
    EXPECT_TRUE(has_fault());
}

TEST_F(AreaFault, ACopyOfAnAreaOnATransferQueue) {
    plan.schedule.queues.push_back({QueueKind::transfer, 1});
    const PassDecl& copy = pass("copy");
    const Position position = plan.schedule.position[PassId(&copy - plan.graph.passes.data())];
    EXPECT_EQ(assign_queues(plan.graph, {PassId(&copy - plan.graph.passes.data())}, plan.schedule.queues),
              std::vector<QueueIndex>{kGraphicsQueue});
    plan.schedule.queue[position] = QueueIndex(1);
    Batch batch;
    batch.queue = QueueIndex(1);
    batch.positions = {position};
    std::erase(plan.submissions.batches[0].positions, position);
    plan.submissions.batches.push_back(batch);
    EXPECT_TRUE(has_fault());
}

TEST_F(AreaFault, OtherWorkgroupsAtScaleOne) {
    pass("shrink").live_groups[1].per = 7;
    EXPECT_TRUE(has_fault());
}

TEST_F(AreaFault, AnotherRectangleAtScaleOne) {
    pass("paint").state.scissor->height += 1;
    EXPECT_TRUE(has_fault());
}

TEST_F(AreaFault, AMemberThatFollowsNoValue) {
    member("paint", "size").live.pop_back();
    EXPECT_TRUE(has_fault());
}

TEST_F(AreaFault, AMemberThatFollowsThePortOfAnotherImage) {
    member("shrink", "srcUv").use = 99;
    EXPECT_TRUE(has_fault());
}

TEST_F(AreaFault, AValueThatDependsOnALaterOne) {
    LiveValue& half = plan.graph.live_values[image("low").area];
    half.steps.front() = {ExprOp::name, 0, image("low").area};
    EXPECT_TRUE(has_fault());
}

TEST_F(AreaFault, AScaleAboveOne) {
    LiveValue& first = plan.graph.live_values.front();
    ASSERT_FALSE(first.most == 0) << "the scale";
    first.most = 2;
    EXPECT_TRUE(has_fault());
}

// After an edit that makes the size fixed, only the area of the old image has content.
class AreaTransition : public LiveTest {
 protected:
    // Returns the plan with a live or a fixed size.
    FramePlan plan_of(bool live, const std::string& on_resize) {
        std::string text = body();
        const auto replace = [&](const std::string& from, const std::string& to) {
            text.replace(text.find(from), from.size(), to);
        };
        replace("\"history\": 2", "\"history\": 2, \"onResize\": \"" + on_resize + "\"");
        if (!live) replace(R"j({"size": "output", "scale": "renderScale"})j", R"j("output")j");
        const ResolvedGraph graph = good(text);
        return compile(graph, content_needs(graph), {});
    }
    // Returns how the content of "past[-1]" gets into the new plan; null: it does not.
    static const ContentCopy* carried(const FramePlan& to, const TransitionPlan& transition) {
        const auto found =
            std::ranges::find(transition.carried, find_resource(to.graph, "past[-1]"), &ContentCopy::to);
        return found == transition.carried.end() ? nullptr : &*found;
    }
};

TEST_F(AreaTransition, ToAFixedSizeIsNoCopy) {
    const FramePlan live = plan_of(true, "clear"), fixed = plan_of(false, "clear");
    EXPECT_EQ(carried(fixed, transition(live, fixed)), nullptr);
    EXPECT_NE(content_text(live, fixed, transition(live, fixed), find_resource(fixed.graph, "past[-1]"))
                  .find("from a live size to a fixed size"),
              std::string::npos);
    const TransitionPlan back = transition(fixed, live);
    ASSERT_NE(carried(live, back), nullptr);
    EXPECT_FALSE(carried(live, back)->resample) << "the whole old image has content";
    EXPECT_TRUE(check_transition(fixed, live, back).empty());
}

TEST_F(AreaTransition, ToAFixedSizeIsScaled) {
    const FramePlan live = plan_of(true, "resample"), fixed = plan_of(false, "resample");
    TransitionPlan between = transition(live, fixed);
    ASSERT_NE(carried(fixed, between), nullptr);
    EXPECT_TRUE(carried(fixed, between)->resample);
    EXPECT_TRUE(check_transition(live, fixed, between).empty());
    for (ContentCopy& copy : between.carried) copy.resample = false;
    const Diagnostics faults = check_transition(live, fixed, between);
    EXPECT_TRUE(std::ranges::any_of(faults, [](const Diagnostic& d) {
        return d.code == "C370" && d.message.find("only the area has content") != std::string::npos;
    }));
}

}  // namespace
}  // namespace weft::test

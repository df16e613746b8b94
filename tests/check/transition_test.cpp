// Tests transitions from one plan to the next: which content is carried over, which is cleared, and that the
// checker finds errors in a transition.
#include <gtest/gtest.h>

#include <functional>

#include "weft/check/check_plan.h"
#include "weft/check/check_transition.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

constexpr ShaderStageMask kCompute = stage_bit(ShaderStage::compute);

struct Shape {
    uint32_t side_px = 16;
    Format format = Format::rgba16f;
    OnResize on_resize = OnResize::resample;
};

UseDecl use_of(const ResolvedGraph& graph, ResourceId id, Access access, PassId producer = kNoId) {
    UseDecl use;
    use.port = "port";
    use.resource = id;
    use.range = graph.resources[id].whole();
    use.access = access;
    use.state = access_state(access, kCompute, aspect::kColor);
    if (reads(access)) use.sources = {{use.range, producer}};
    return use;
}

ResourceDecl image(const char* name, const Shape& shape, uint32_t history, ResourceId ring, uint32_t age) {
    ResourceDecl decl;
    decl.name = name;
    decl.lifetime = ResourceLifetime::persistent;
    decl.format = shape.format;
    decl.extent = {shape.side_px, shape.side_px, 1};
    decl.history = history;
    decl.ring = ring;
    decl.age = age;
    decl.on_resize = shape.on_resize;
    return decl;
}

// Returns a plan with two persistent images: `color` is blended with its previous frame, and `kept` is
// modified in place.
FramePlan planned(const Shape& shape, const Shape& kept = {}) {
    ResolvedGraph graph;
    graph.resources = {image("color", shape, 1, 0, 0), image("color[-1]", shape, 1, 0, 1),
                       image("kept", kept, 0, 2, 0)};
    PassDecl blend, touch;
    blend.name = "blend";
    touch.name = "touch";
    blend.side_effect = touch.side_effect = true;
    blend.uses = {use_of(graph, 1, Access::sampled_read), use_of(graph, 0, Access::storage_write)};
    touch.uses = {use_of(graph, 2, Access::storage_read_write)};
    graph.passes = {blend, touch};
    return compile(graph, content_needs(graph), {});
}

TEST(Transition, ASwapThatChangesNothingCarriesEverything) {
    const FramePlan old_plan = planned({}), new_plan = planned({});
    ASSERT_TRUE(check_plan(old_plan).empty()) << to_text(check_plan(old_plan));
    const TransitionPlan plan = transition(old_plan, new_plan);
    EXPECT_EQ(plan.carried, (std::vector<ContentCopy>{{1, 1, false}, {2, 2, false}}));
    EXPECT_EQ(plan.cleared, std::vector<ResourceId>{0});
    EXPECT_EQ(plan.keeps_validity, (std::vector<uint8_t>{1, 0, 1}));
    const Diagnostics faults = check_transition(old_plan, new_plan, plan);
    EXPECT_TRUE(faults.empty()) << to_text(faults);
}

TEST(Transition, AResizeStretchesWhatIsToBeStretched) {
    const FramePlan old_plan = planned({16}, {16}),
                    new_plan = planned({7}, {7, Format::rgba16f, OnResize::clear});
    const TransitionPlan plan = transition(old_plan, new_plan);
    EXPECT_EQ(plan.carried, (std::vector<ContentCopy>{{1, 1, true}}));
    EXPECT_EQ(plan.cleared, (std::vector<ResourceId>{0, 2}));
    EXPECT_EQ(plan.keeps_validity, (std::vector<uint8_t>{1, 0, 0}));
    const Diagnostics faults = check_transition(old_plan, new_plan, plan);
    EXPECT_TRUE(faults.empty()) << to_text(faults);
}

TEST(Transition, AnotherFormatStartsAfresh) {
    const FramePlan old_plan = planned({}), new_plan = planned({16, Format::rgba32f});
    const TransitionPlan plan = transition(old_plan, new_plan);
    EXPECT_EQ(plan.carried, (std::vector<ContentCopy>{{2, 2, false}}));
    EXPECT_EQ(plan.keeps_validity, (std::vector<uint8_t>{0, 0, 1}));
    EXPECT_TRUE(check_transition(old_plan, new_plan, plan).empty());
}

TEST(Transition, PlantedFaultsAreCaught) {
    const FramePlan old_plan = planned({}), new_plan = planned({});
    const std::vector<std::function<void(TransitionPlan&)>> faults{
        [](TransitionPlan& t) { t.carried.pop_back(); },
        [](TransitionPlan& t) { t.cleared.push_back(1); },
        [](TransitionPlan& t) { t.carried.front().from = 0; },
        [](TransitionPlan& t) { t.carried.front().resample = true; },
        [](TransitionPlan& t) { t.before_old.clear(); },
        [](TransitionPlan& t) { t.before_old.front().src.stages &= ~stage::kComputeShader; },
        [](TransitionPlan& t) { t.before_old.front().src.layout = Layout::color_attachment; },
        [](TransitionPlan& t) { t.before.pop_back(); },
        [](TransitionPlan& t) { t.after.front().src.access = access::kNone; },
        [](TransitionPlan& t) { t.after.front().dst.stages &= ~stage::kFragmentShader; },
        [](TransitionPlan& t) { t.after.back().dst.layout = Layout::undefined; }};
    for (size_t i = 0; i < faults.size(); ++i) {
        TransitionPlan plan = transition(old_plan, new_plan);
        faults[i](plan);
        EXPECT_FALSE(check_transition(old_plan, new_plan, plan).empty()) << "fault " << i;
    }
}

}  // namespace
}  // namespace weft::test

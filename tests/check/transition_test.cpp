// Tests transitions from one plan to the next: which content is carried over, which is cleared, and that the
// checker finds errors in a transition.
#include <gtest/gtest.h>

#include <algorithm>
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
    bool shared = false;
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
    decl.shared = shape.shared && history == 0;
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

TEST(Transition, AnotherFormatOfFloatsIsConverted) {
    const FramePlan old_plan = planned({}), new_plan = planned({16, Format::rgba32f});
    const TransitionPlan plan = transition(old_plan, new_plan);
    EXPECT_EQ(plan.carried, (std::vector<ContentCopy>{{1, 1, true}, {2, 2, false}}));
    EXPECT_EQ(plan.keeps_validity, (std::vector<uint8_t>{1, 0, 1}));
    EXPECT_TRUE(check_transition(old_plan, new_plan, plan).empty());
}

TEST(Transition, AnotherFormatStartsAfreshWithoutResampleInBothOrOfAnotherKind) {
    const Shape cleared{16, Format::rgba16f, OnResize::clear};
    for (const auto& [from, to] :
         {std::pair{Shape{}, Shape{16, Format::rgba32f, OnResize::clear}},
          std::pair{cleared, Shape{16, Format::rgba32f}}, std::pair{Shape{}, Shape{16, Format::rgba32u}}}) {
        const FramePlan old_plan = planned(from), new_plan = planned(to);
        const TransitionPlan plan = transition(old_plan, new_plan);
        EXPECT_EQ(plan.carried, (std::vector<ContentCopy>{{2, 2, false}}));
        EXPECT_EQ(plan.keeps_validity, (std::vector<uint8_t>{0, 0, 1}));
        EXPECT_TRUE(check_transition(old_plan, new_plan, plan).empty());
    }
}

constexpr Shape kShared{16, Format::rgba16f, OnResize::resample, true};

TEST(Transition, SharedMemoryIsNotCopied) {
    const FramePlan old_plan = planned({}, kShared), new_plan = planned({}, kShared);
    ASSERT_TRUE(check_plan(new_plan).empty()) << to_text(check_plan(new_plan));
    const TransitionPlan plan = transition(old_plan, new_plan);
    EXPECT_EQ(plan.carried, (std::vector<ContentCopy>{{1, 1, false}, {2, 2, false, true}}));
    EXPECT_EQ(content_text(old_plan, new_plan, plan, 2), "\"kept\" keeps its memory");
    EXPECT_TRUE(check_transition(old_plan, new_plan, plan).empty())
        << to_text(check_transition(old_plan, new_plan, plan));
    // Another size or format, or a plan that does not share the memory.
    for (const Shape& other : {Shape{}, Shape{8, Format::rgba16f, OnResize::resample, true},
                               Shape{16, Format::rgba32f, OnResize::resample, true}}) {
        const FramePlan next = planned({}, other);
        const TransitionPlan copied = transition(old_plan, next);
        EXPECT_FALSE(copied.carried.back().shared);
        EXPECT_TRUE(check_transition(old_plan, next, copied).empty());
    }
}

TEST(Transition, FaultsInSharedMemoryAreCaught) {
    const FramePlan old_plan = planned({}, kShared), new_plan = planned({}, kShared);
    const std::vector<std::function<void(TransitionPlan&)>> faults{
        [](TransitionPlan& t) { t.carried.pop_back(); },
        [](TransitionPlan& t) { t.cleared.push_back(2); },
        [](TransitionPlan& t) { t.carried.back().resample = true; },
        [](TransitionPlan& t) { t.after.pop_back(); },
        [](TransitionPlan& t) { t.after.back().src.stages = stage::kComputeShader; },
        [](TransitionPlan& t) { t.after.back().src.layout = Layout::undefined; },
        [](TransitionPlan& t) { t.after.back().dst.layout = Layout::undefined; },
        [](TransitionPlan& t) { t.after.back().src.access = access::kNone; }};
    for (size_t i = 0; i < faults.size(); ++i) {
        TransitionPlan plan = transition(old_plan, new_plan);
        faults[i](plan);
        EXPECT_FALSE(check_transition(old_plan, new_plan, plan).empty()) << "fault " << i;
    }
    TransitionPlan plan = transition(old_plan, new_plan);
    for (const Shape& other : {Shape{}, Shape{8, Format::rgba16f, OnResize::resample, true}}) {
        const Diagnostics found = check_transition(planned({}, other), new_plan, plan);
        ASSERT_FALSE(found.empty());
        EXPECT_EQ(found.front().code, "C338");
    }
}

TEST(Transition, ASharedResourceHasAHeapOfItsOwn) {
    const FramePlan right = planned({}, kShared);
    const auto expect_fault = [](const FramePlan& plan) {
        const Diagnostics found = check_plan(plan);
        EXPECT_TRUE(std::ranges::any_of(found, [](const Diagnostic& d) { return d.code == "C338"; }))
            << to_text(found);
    };
    const auto placement = [](FramePlan& plan, ResourceId id) -> Placement& {
        return *std::ranges::find(plan.memory.placements, id, &Placement::resource);
    };
    FramePlan plan = right;
    plan.memory.heaps[placement(plan, ResourceId(2)).heap].shared = false;
    expect_fault(plan);
    plan = right;
    const uint32_t heap = placement(plan, ResourceId(2)).heap;
    plan.memory.heaps[heap].size_bytes += placement(plan, ResourceId(0)).size_bytes;
    placement(plan, ResourceId(0)).offset_bytes = placement(plan, ResourceId(2)).size_bytes;
    placement(plan, ResourceId(0)).heap = heap;
    expect_fault(plan);
}

// A resource may begin or end to have a history. Its newest content stays.
TEST(Transition, AHistoryMayBeginOrEnd) {
    const auto single = [] {
        ResolvedGraph graph;
        graph.resources = {image("color", {}, 0, 0, 0)};
        PassDecl touch;
        touch.name = "touch";
        touch.side_effect = true;
        touch.uses = {use_of(graph, 0, Access::storage_read_write)};
        graph.passes = {touch};
        return compile(graph, content_needs(graph), {});
    };
    const FramePlan ring = planned({}), one = single();
    const TransitionPlan begins = transition(one, ring), ends = transition(ring, one);
    EXPECT_EQ(begins.carried, (std::vector<ContentCopy>{{0, 1, false}}));
    EXPECT_EQ(ends.carried, (std::vector<ContentCopy>{{1, 0, false}}));
    EXPECT_TRUE(check_transition(one, ring, begins).empty());
    EXPECT_TRUE(check_transition(ring, one, ends).empty());
    TransitionPlan wrong = ends;
    wrong.carried.front().from = 0;
    EXPECT_FALSE(check_transition(ring, one, wrong).empty());
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

// Each test breaks a correct plan whose pass "faces" draws several views. The checker must report C346.
#include <gtest/gtest.h>

#include <functional>

#include "tests/graph/samples/graph_builder.h"
#include "tests/graph/samples/random_graph.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

constexpr uint32_t kViews = 3;

// A pass that draws three views to the layers of "a", and a second one that continues its rendering scope.
FramePlan view_plan() {
    GraphBuilder builder;
    builder.add_view_list("probe", 6);
    const ResourceId a = builder.image("a", Format::r32u, 16, 1, kViews);
    const auto draw = [&](const char* name, Access access) {
        PassDecl& pass = builder.pass(name, PassKind::fullscreen, {{"color", a, access, {}, kNoId}});
        pass.lowering = ViewLowering::multiview;
        pass.views = {"probe(2)", "probe(3)", "probe(4)"};
        pass.view = pass.views.front();
    };
    draw("faces", Access::color_write);
    draw("more", Access::color_read_write);
    builder.pass("keep", PassKind::readback, {{"src", a, Access::copy_read, {}, kNoId}});
    const ResolvedGraph graph = builder.build();
    return compile(graph, content_needs(graph), {});
}

void expect_fault(const char* what, const std::function<void(FramePlan&, PassDecl&)>& change,
                  const char* code = "C346") {
    SCOPED_TRACE(what);
    FramePlan plan = view_plan();
    change(plan, plan.graph.passes[find_pass(plan.graph, "faces")]);
    const Diagnostics faults = check_plan(plan);
    ASSERT_FALSE(faults.empty());
    EXPECT_EQ(faults.front().code, code) << to_text(faults);
    EXPECT_NE(faults.front().message.find(code == std::string("C306") ? "more" : "faces"), std::string::npos);
}

TEST(ViewFaults, TheCorrectPlanHasNone) {
    const FramePlan plan = view_plan();
    EXPECT_TRUE(check_plan(plan).empty()) << to_text(check_plan(plan));
    uint32_t merged = 0;
    for (const PassStep& step : plan.barriers.steps) merged += step.merges_render_pass ? 1 : 0;
    EXPECT_EQ(merged, 1u);
}

TEST(ViewFaults, OfTheViewsAreFound) {
    expect_fault("no lowering", [](FramePlan&, PassDecl& pass) { pass.lowering = ViewLowering::none; });
    expect_fault("no views", [](FramePlan&, PassDecl& pass) { pass.views.clear(); });
    expect_fault("another first view", [](FramePlan&, PassDecl& pass) { pass.view = "probe(1)"; });
    expect_fault("a gap", [](FramePlan&, PassDecl& pass) { pass.views[1] = "probe(5)"; });
    expect_fault("two lists", [](FramePlan&, PassDecl& pass) { pass.views[1] = "sun(3)"; });
    expect_fault("an unknown list", [](FramePlan& plan, PassDecl&) { plan.graph.views.clear(); });
    expect_fault("a short list", [](FramePlan& plan, PassDecl&) { plan.graph.views[0].count = 4; });
    expect_fault("a name without a number",
                 [](FramePlan&, PassDecl& pass) { pass.view = pass.views[0] = "probe("; });
}

TEST(ViewFaults, OfTheLayersAreFound) {
    expect_fault("a layer too few", [](FramePlan&, PassDecl& pass) { pass.views.pop_back(); });
    expect_fault("a layer too many", [](FramePlan&, PassDecl& pass) { pass.views.push_back("probe(5)"); });
    expect_fault("multisampling", [](FramePlan& plan, PassDecl&) { plan.graph.resources[0].samples = 4; });
    expect_fault("a slice of frames", [](FramePlan&, PassDecl& pass) { pass.frame_slices = 1; });
    expect_fault("another write", [](FramePlan&, PassDecl& pass) { pass.colors.clear(); });
    expect_fault("a resolve", [](FramePlan&, PassDecl& pass) { pass.colors[0].resolve_use = 0; });
}

// The mask of views belongs to the whole rendering scope.
TEST(ViewFaults, OfASharedScopeAreFound) {
    expect_fault(
        "two lowerings", [](FramePlan&, PassDecl& pass) { pass.lowering = ViewLowering::layer_output; },
        "C306");
}

}  // namespace
}  // namespace weft::test

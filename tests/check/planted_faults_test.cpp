// Each test breaks a correct plan in one way. The checker must report an error. In most tests, the error must
// name the passes and the resource that the fault concerns.
#include <gtest/gtest.h>

#include <algorithm>

#include "check/needed_barriers.h"
#include "tests/graph/resolve/resolve_fixture.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

// The passes make → blur → sharpen → down0 → down1 → down2 → shade → tint → show form a chain, in which later
// images reuse the memory of earlier ones. The passes down0 to down2 write the mips of the image "chain". The
// passes "geometry" and "overlay" test against the same depth buffer.
const char* const kGraph = R"j(
 "imports": {"backbuffer": "output", "opaque": "drawlist"},
 "resources": {"a": "rgba16f", "b": "rgba16f", "c": "rgba16f", "d": "rgba16f", "chain": {"format": "rgba16f", "mips": 3},
               "z": "d32f", "color": "rgba16f"},
 "passes": {
  "make":     {"type": "compute", "shader": "make.comp", "out": {"dst": "a"}},
  "blur":     {"type": "compute", "shader": "filter.comp", "in": {"src": "a"}, "out": {"dst": "b"}},
  "sharpen":  {"type": "compute", "shader": "filter.comp", "in": {"src": "b"}, "out": {"dst": "c"}},
  "down0":    {"type": "compute", "shader": "filter.comp", "in": {"src": "c"}, "out": {"dst": "chain.mip(0)"}},
  "down1":    {"type": "compute", "shader": "filter.comp", "in": {"src": "chain.mip(0)"}, "out": {"dst": "chain.mip(1)"}},
  "down2":    {"type": "compute", "shader": "filter.comp", "in": {"src": "chain.mip(1)"}, "out": {"dst": "chain.mip(2)"}},
  "geometry": {"type": "raster", "shader": "color", "draws": ["opaque"], "depth": "z", "out": ["color"],
               "state": {"depth": "greater_write"}},
  "overlay":  {"type": "raster", "shader": "color", "draws": ["opaque"], "depth": "z", "out": ["color"],
               "state": {"depth": "greater_write", "blend": "add"}, "after": ["geometry"]},
  "shade":    {"type": "compute", "shader": "shade.comp", "in": {"src": "chain", "color": "color", "z": "z"}, "out": {"dst": "d"}},
  "tint":     {"type": "compute", "shader": "change.comp", "out": {"x": "d"}},
  "show":     {"type": "fullscreen", "shader": "show.frag", "in": {"src": "d"}, "out": ["backbuffer"]}})j";

class PlantedFault : public ResolveTest {
 protected:
    PlantedFault() {
        shaders["make.comp"] = compute({image_out("dst")});
        shaders["filter.comp"] = compute({sampled("src"), image_out("dst")});
        shaders["shade.comp"] = compute({sampled("src"), sampled("color"), sampled("z"), image_out("dst")});
        shaders["change.comp"] = compute({image_in_out("x")});
        shaders["show.frag"] = fragment({"backbuffer"}, {sampled("src")});
        shaders["color"] = fragment({"color"});
        plan = compile(good(kGraph), content_needs(good(kGraph)), {});
    }

    PassId pass(const char* name) const { return find_pass(plan.graph, name); }
    ResourceId resource(const char* name) const { return find_resource(plan.graph, name); }
    PassStep& step(const char* name) { return plan.barriers.steps[plan.schedule.position[pass(name)]]; }
    BarrierDecl& barrier(const char* before, const char* on) {
        for (BarrierDecl& b : step(before).barriers)
            if (b.resource == resource(on)) return b;
        ADD_FAILURE() << "no barrier on " << on << " before " << before;
        static BarrierDecl none;
        return none;
    }
    void drop_barriers(const char* before, const char* on) {
        const size_t dropped = std::erase_if(
            step(before).barriers, [&](const BarrierDecl& b) { return b.resource == resource(on); });
        EXPECT_GT(dropped, 0u) << "no barrier on " << on << " before " << before;
    }

    // Expects that at least one error of the checker mentions all of these names.
    void expect_fault(std::initializer_list<const char*> names) {
        const Diagnostics faults = check_plan(plan);
        const bool found = std::any_of(faults.begin(), faults.end(), [&](const Diagnostic& d) {
            return std::all_of(names.begin(), names.end(), [&](const char* name) {
                return d.message.find('"' + std::string(name) + '"') != std::string::npos;
            });
        });
        EXPECT_TRUE(found) << (faults.empty() ? "no fault was found" : to_text(faults));
    }

    FramePlan plan;
};

TEST_F(PlantedFault, NoneInTheSoundPlan) {
    const Diagnostics faults = check_plan(plan);
    EXPECT_TRUE(faults.empty()) << to_text(faults);
}

TEST_F(PlantedFault, BarrierDropped) {
    drop_barriers("blur", "a");
    expect_fault({"blur", "make", "a"});
}

TEST_F(PlantedFault, NeededBarriersAreThoseWithoutWhichAFaultIsFound) {
    EXPECT_EQ(count_needed_barriers(plan), plan.barriers.emitted);
    BarrierDecl again = barrier("blur", "a");
    again.src = again.dst;
    step("blur").barriers.push_back(again);
    const uint32_t needed = plan.barriers.emitted++;
    ASSERT_TRUE(check_plan(plan).empty()) << to_text(check_plan(plan));
    EXPECT_EQ(count_needed_barriers(plan), needed);
    EXPECT_EQ(count_needed_barriers(plan, 10), std::nullopt) << "more work than is allowed";
}

TEST_F(PlantedFault, StageWeakened) {
    barrier("blur", "a").src.stages = stage::kCopy;
    expect_fault({"blur", "make", "a"});
}

TEST_F(PlantedFault, DestinationStageWeakened) {
    barrier("show", "d").dst.stages = stage::kColorOutput;
    expect_fault({"show", "d"});
}

TEST_F(PlantedFault, AccessWeakened) {
    barrier("blur", "a").src.access = access::kNone;
    expect_fault({"blur", "make", "a"});
}

TEST_F(PlantedFault, DestinationAccessWeakened) {
    barrier("tint", "d").dst.access &= ~access::kStorageRead;
    expect_fault({"tint", "d", "shade"});
}

TEST_F(PlantedFault, LayoutWrong) {
    barrier("blur", "a").dst.layout = Layout::general;
    expect_fault({"blur", "a"});
    barrier("blur", "a").dst.layout = Layout::shader_read_only;
    barrier("blur", "a").src.layout = Layout::transfer_dst;
    expect_fault({"blur", "make", "a"});
}

TEST_F(PlantedFault, LivePlacementsOverlap) {
    std::vector<Placement>& all = plan.memory.placements;
    const auto of = [&](const char* name) {
        return std::find_if(all.begin(), all.end(),
                            [&](const Placement& p) { return p.resource == resource(name); });
    };
    of("b")->heap = of("a")->heap;
    of("b")->offset_bytes = of("a")->offset_bytes;
    expect_fault({"a", "b", "make", "blur"});
}

// Finds the first barrier that hands memory from one resource to another within a frame. Changes the barrier
// so that it waits for no pass, and removes the transitions to the second resource from the memory plan.
TEST_F(PlantedFault, AliasTransitionDropped) {
    for (PassStep& s : plan.barriers.steps) {
        for (size_t i = 0; i < s.barriers.size(); ++i) {
            const BarrierDecl b = s.barriers[i];
            if (b.reason != BarrierReason::alias || b.from_previous_frame) continue;
            const std::string from = plan.graph.resources[b.aliased_from.front()].name;
            const std::string to = plan.graph.resources[b.resource].name;
            ASSERT_NE(from, to);
            std::erase_if(plan.memory.alias_transitions,
                          [&](const AliasTransition& h) { return h.to == b.resource; });
            s.barriers[i].aliased_from.clear();
            s.barriers[i].src = {stage::kHost, 0, Layout::undefined};
            expect_fault({plan.graph.passes[s.pass].name.c_str(), from.c_str(), to.c_str()});
            return;
        }
    }
    FAIL() << "this graph hands no memory over within a frame";
}

TEST_F(PlantedFault, AliasTransitionDroppedFromTheMemoryPlanOnly) {
    ASSERT_FALSE(plan.memory.alias_transitions.empty());
    const AliasTransition dropped = plan.memory.alias_transitions.front();
    plan.memory.alias_transitions.erase(plan.memory.alias_transitions.begin());
    expect_fault(
        {plan.graph.resources[dropped.from].name.c_str(), plan.graph.resources[dropped.to].name.c_str()});
}

TEST_F(PlantedFault, WrapAroundAliasTransitionDropped) {
    for (PassStep& s : plan.barriers.steps) {
        for (BarrierDecl& b : s.barriers) {
            if (b.reason != BarrierReason::alias || !b.from_previous_frame) continue;
            b.src = {stage::kHost, 0, Layout::undefined};
            expect_fault(
                {plan.graph.passes[s.pass].name.c_str(), plan.graph.resources[b.resource].name.c_str()});
            return;
        }
    }
    FAIL() << "this graph hands no memory over from frame to frame";
}

// Pass "tint" overwrites x after pass "peek" has read x. The test removes the reader's stage from the
// barrier, so "tint" no longer waits for "peek".
TEST_F(PlantedFault, WarEdgeDropped) {
    const char* const war = R"j(
     "imports": {"backbuffer": "output"}, "resources": {"x": "rgba16f", "y": "rgba16f"},
     "passes": {
      "make":  {"type": "compute", "shader": "make.comp", "out": {"dst": "x"}},
      "peek":  {"type": "fullscreen", "shader": "peek.frag", "in": {"src": "x@make"}, "out": ["y"]},
      "tint":  {"type": "compute", "shader": "change.comp", "out": ["x"]},
      "show":  {"type": "fullscreen", "shader": "both.frag", "in": ["x", "y"], "out": ["backbuffer"]}})j";
    shaders["peek.frag"] = fragment({"y"}, {sampled("src")});
    shaders["both.frag"] = fragment({"backbuffer"}, {sampled("x"), sampled("y")});
    plan = compile(good(war), content_needs(good(war)), {});
    ASSERT_TRUE(check_plan(plan).empty()) << to_text(check_plan(plan));
    for (BarrierDecl& b : step("tint").barriers)
        if (b.resource == resource("x")) b.src.stages &= ~stage::kFragmentShader;
    expect_fault({"tint", "peek", "x"});
}

TEST_F(PlantedFault, WrongMipRange) {
    barrier("down1", "chain").range.mip += 1;
    expect_fault({"down1", "chain"});
}

TEST_F(PlantedFault, LifetimeCutByOne) {
    Position& last = plan.lifetimes.spans[resource("a")].last;
    last = Position(last - 1);
    expect_fault({"blur", "make", "a"});
}

TEST_F(PlantedFault, DontCareLoadOfLiveData) {
    AttachmentOps& color = step("overlay").attachments.front();
    ASSERT_EQ(color.load, LoadOp::load);
    color.load = LoadOp::dont_care;
    expect_fault({"overlay", "geometry", "color"});
}

TEST_F(PlantedFault, DontCareStoreOfLiveData) {
    step("overlay").attachments.front().store = StoreOp::dont_care;
    expect_fault({"shade", "overlay", "color"});
}

TEST_F(PlantedFault, PassOrderSwapped) {
    const uint32_t i = plan.schedule.position[pass("sharpen")], j = plan.schedule.position[pass("blur")];
    std::swap(plan.schedule.order[i], plan.schedule.order[j]);
    std::swap(plan.barriers.steps[i], plan.barriers.steps[j]);
    expect_fault({"sharpen", "blur", "b"});
}

TEST_F(PlantedFault, PassForgotten) {
    plan.schedule.order.pop_back();
    plan.barriers.steps.pop_back();
    plan.submissions.batches.back().positions.pop_back();
    EXPECT_FALSE(check_plan(plan).empty());
}

TEST_F(PlantedFault, ExitStateForgotten) {
    ASSERT_FALSE(plan.barriers.epilogue.empty());
    plan.barriers.epilogue.clear();
    expect_fault({"show", "backbuffer"});
}

}  // namespace
}  // namespace weft::test

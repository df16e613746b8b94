#include <gtest/gtest.h>

#include <algorithm>

#include "graph/schedule/schedule.h"
#include "graph/schedule/schedule_candidates.h"
#include "tests/graph/samples/graph_builder.h"
#include "tests/graph/samples/hand_made.h"
#include "tests/graph/samples/random_graph.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

// Returns a graph that first produces many results and then adds them up one by one. In program order, all
// results live at the same time.
ResolvedGraph produce_then_fold(uint32_t count) {
    GraphBuilder b;
    const ResourceId sum = b.buffer("sum", 16);
    std::vector<ResourceId> parts;
    b.pass("start", PassKind::clear, {{"dst", sum, Access::clear_write, {}, kNoId}});
    for (uint32_t i = 0; i < count; ++i) {
        parts.push_back(b.buffer("part" + std::to_string(i), 4096));
        b.compute("make" + std::to_string(i), {{"dst", parts.back(), Access::storage_write, {}, kNoId}});
    }
    for (uint32_t i = 0; i < count; ++i)
        b.compute("fold" + std::to_string(i), {{"src", parts[i], Access::storage_read, {}, kNoId},
                                               {"dst", sum, Access::storage_read_write, {}, kNoId}});
    b.pass("out", PassKind::readback, {{"src", sum, Access::copy_read, {}, kNoId}});
    return b.build();
}

std::string names(const ResolvedGraph& graph, const std::vector<PassId>& order) {
    std::string text;
    for (const PassId pass : order) text += graph.passes[pass].name + " ";
    return text;
}

TEST(Schedule, GreedyOrdersSaveMemoryThatProgramOrderWastes) {
    const ResolvedGraph graph = produce_then_fold(8);
    const Schedule order = schedule(graph, all_live(graph), content_needs(graph));
    EXPECT_EQ(order.candidates[0].peak_live_bytes, 8u * 4096 + 16);
    EXPECT_NE(order.chosen, "program");
    const auto chosen = std::find_if(order.candidates.begin(), order.candidates.end(),
                                     [&](const ScheduleCandidate& c) { return c.name == order.chosen; });
    EXPECT_EQ(chosen->peak_live_bytes, 4096u + 16);
}

TEST(Schedule, ProgramOrderFollowsKeysThenNames) {
    GraphBuilder b;
    const ResourceId x = b.buffer("x"), y = b.buffer("y");
    b.pass("late_name", PassKind::clear, {{"dst", x, Access::clear_write, {}, kNoId}}).order_key = 0;
    b.pass("early_name", PassKind::clear, {{"dst", y, Access::clear_write, {}, kNoId}}).order_key = 1;
    b.pass("b_read", PassKind::readback, {{"src", x, Access::copy_read, {}, kNoId}}).order_key = 2;
    b.pass("a_read", PassKind::readback, {{"src", y, Access::copy_read, {}, kNoId}}).order_key = 2;
    const ResolvedGraph graph = b.build();
    const ScheduleProblem problem = schedule_problem(graph, all_live(graph), content_needs(graph));
    EXPECT_EQ(names(graph, program_order(problem)), "late_name early_name a_read b_read ");
}

TEST(Schedule, OrderThroughACulledPassHolds) {
    GraphBuilder b;
    const ResourceId x = b.buffer("x"), y = b.buffer("y"), z = b.buffer("z");
    b.pass("first", PassKind::clear, {{"dst", x, Access::clear_write, {}, kNoId}}).order_key = 9;
    b.pass("dropped", PassKind::clear, {{"dst", y, Access::clear_write, {}, kNoId}});
    b.pass("second", PassKind::clear, {{"dst", z, Access::clear_write, {}, kNoId}}).order_key = 0;
    b.pass("out_x", PassKind::readback, {{"src", x, Access::copy_read, {}, kNoId}});
    b.pass("out_z", PassKind::readback, {{"src", z, Access::copy_read, {}, kNoId}});
    b.after("first", "dropped");
    b.after("dropped", "second");
    const ResolvedGraph graph = b.build();
    LiveGraph live = all_live(graph);
    live.live_passes[pass_of(graph, "dropped")] = 0;
    const Schedule order = schedule(graph, live, content_needs(graph));
    const auto at = [&](const char* name) { return order.position[find_pass(graph, name)]; };
    EXPECT_EQ(at("dropped"), kNoId);
    EXPECT_LT(at("first"), at("second"));
}

TEST(Schedule, EveryCandidateRespectsEveryEdge) {
    for (uint32_t seed = 0; seed < 60; ++seed) {
        const ResolvedGraph graph = random_graph(seed);
        LiveGraph live = all_live(graph);
        for (PassId pass(0); pass < graph.passes.size(); ++pass)
            // Culls a quarter of the passes, because schedules must be correct for any set of live passes.
            live.live_passes[pass] = (pass + seed) % 4 != 0;
        const ScheduleProblem problem = schedule_problem(graph, live, content_needs(graph));
        for (const auto& order :
             {program_order(problem), forward_greedy_order(problem), backward_greedy_order(problem)}) {
            std::vector<Position> position(graph.passes.size(), kNoId);
            for (Position p(0); p < order.size(); ++p) position[order[p]] = p;
            for (PassId pass(0); pass < graph.passes.size(); ++pass)
                EXPECT_EQ(position[pass] != kNoId, live.live_passes[pass] != 0);
            for (const EdgeDecl& edge : graph.edges) {
                if (position[edge.from] == kNoId || position[edge.to] == kNoId) continue;
                EXPECT_LT(position[edge.from], position[edge.to]) << "seed " << seed;
            }
        }
    }
}

}  // namespace
}  // namespace weft::test

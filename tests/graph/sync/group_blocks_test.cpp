#include "graph/sync/group_blocks.h"

#include <gtest/gtest.h>

#include "tests/graph/samples/graph_builder.h"
#include "tests/graph/samples/hand_made.h"

namespace weft::test {
namespace {

// Two groups: "first" has the positions 1 to 3, "none" has only culled passes.
class GroupBlocks : public ::testing::Test {
 protected:
    GroupBlocks() {
        GraphBuilder b;
        const ResourceId x = b.buffer("x");
        const auto add = [&](const char* name, uint32_t unit) {
            b.pass(name, PassKind::readback, {{"src", x, Access::copy_read, {}, kNoId}}).rest_unit = unit;
        };
        add("before", 0);
        add("make0", 1);
        add("make1", 2);
        add("store1", 2);
        add("after", kNoId);
        add("culled", 3);
        graph = b.build();
        graph.rest_unit_count = 4;
        graph.groups.push_back({.name = "first", .first_unit = 1, .rounds = 2});
        graph.groups.push_back({.name = "none", .first_unit = 3, .rounds = 1});
        order = in_order(graph, {"before", "make0", "make1", "store1", "after"});
        blocks = group_blocks(graph, order);
    }

    static BarrierDecl barrier(ResourceId resource, bool if_pass_runs) {
        BarrierDecl made;
        made.resource = resource;
        made.if_pass_runs = if_pass_runs;
        return made;
    }
    // Returns the resources of the barriers, with "?" behind those that are recorded only if the pass runs.
    static std::string text(const std::vector<BarrierDecl>& barriers) {
        std::string all;
        for (const BarrierDecl& b : barriers)
            all += std::to_string(b.resource) + (b.if_pass_runs ? "? " : " ");
        return all;
    }

    ResolvedGraph graph;
    Schedule order;
    std::vector<GroupBlock> blocks;
};

TEST_F(GroupBlocks, ReachFromTheFirstToTheLastLivePass) {
    ASSERT_EQ(blocks.size(), 2u);
    EXPECT_EQ(blocks[0].first, 1u);
    EXPECT_EQ(blocks[0].last, 3u);
    EXPECT_FALSE(blocks[0].contains(Position(0)));
    EXPECT_TRUE(blocks[0].contains(Position(3)));
    EXPECT_FALSE(blocks[0].contains(Position(4)));
    EXPECT_TRUE(blocks[1].empty());
}

TEST_F(GroupBlocks, DependenciesMoveToTheBorders) {
    const std::vector<QueueDependency> moved = outside_blocks(
        blocks, {{0, 2, false, 5}, {2, 4, false, 6}, {3, 1, true, 7}, {0, 4, false, 8}, {2, 5, false, 9}});
    const std::vector<QueueDependency> wanted{
        {0, 1, false, 5}, {3, 4, false, 6}, {3, 1, true, 7}, {0, 4, false, 8}, {3, 5, false, 9}};
    EXPECT_EQ(moved, wanted);
}

TEST_F(GroupBlocks, SharedBarriersMoveToTheBorders) {
    BarrierPlan plan;
    for (const PassId pass : order.order) plan.steps.emplace_back().pass = pass;
    const auto id = [](uint32_t number) { return ResourceId(number); };
    plan.steps[0].barriers = {barrier(id(0), false)};
    plan.steps[1].barriers = {barrier(id(1), true), barrier(id(2), false)};
    plan.steps[2].barriers = {barrier(id(3), false), barrier(id(4), true)};
    plan.steps[3].barriers = {barrier(id(5), false)};
    plan.steps[4].barriers = {barrier(id(6), false)};
    plan.steps[0].after = {barrier(id(10), false)};
    plan.steps[1].after = {barrier(id(11), false), barrier(id(12), true)};
    plan.steps[3].after = {barrier(id(13), false)};
    for (PassStep& step : plan.steps)
        for (BarrierDecl& made : step.barriers) made.to = step.pass;
    move_shared_barriers(blocks, plan);
    EXPECT_EQ(text(plan.steps[0].barriers), "0 ");
    EXPECT_EQ(text(plan.steps[1].barriers), "1? 2 3 5 ");
    EXPECT_EQ(text(plan.steps[2].barriers), "4? ");
    EXPECT_EQ(text(plan.steps[3].barriers), "");
    EXPECT_EQ(text(plan.steps[4].barriers), "6 ");
    EXPECT_EQ(text(plan.steps[0].after), "10 ");
    EXPECT_EQ(text(plan.steps[1].after), "12? ");
    EXPECT_EQ(text(plan.steps[3].after), "13 11 ");
    for (const BarrierDecl& made : plan.steps[1].barriers)
        EXPECT_EQ(made.to, plan.steps[1].pass) << "the barrier stands before this pass now";
}

}  // namespace
}  // namespace weft::test

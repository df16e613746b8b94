// Tests WholeTracker, which handles only the usual case, with the resources of random graphs. It must give
// the same histories as track_resource(), which handles all cases.
#include "graph/sync/track_whole.h"

#include <gtest/gtest.h>

#include <tuple>

#include "graph/schedule/attachment_ops.h"
#include "graph/sync/scopes.h"
#include "tests/graph/samples/graph_builder.h"
#include "tests/graph/samples/hand_made.h"
#include "tests/graph/samples/random_plan.h"

namespace weft::test {
namespace {

void expect_same(const ResourceHistory& found, const ResourceHistory& expected, const std::string& where) {
    const auto fields = [](const PlacedBarrier& p) {
        const TrackedBarrier& b = p.barrier;
        return std::make_tuple(p.position, p.after, b.range, b.src, b.dst, b.src_family, b.dst_family,
                               b.reason, b.from, b.from_previous_frame);
    };
    ASSERT_EQ(found.barriers.size(), expected.barriers.size()) << where;
    for (size_t i = 0; i < found.barriers.size(); ++i)
        EXPECT_TRUE(fields(found.barriers[i]) == fields(expected.barriers[i])) << where << ", barrier " << i;
    const auto uses = [](const LastUse& u) {
        return std::make_tuple(u.queue, u.position, u.stages, u.writes, u.pass);
    };
    ASSERT_EQ(found.last_uses.size(), expected.last_uses.size()) << where;
    for (size_t i = 0; i < found.last_uses.size(); ++i)
        EXPECT_TRUE(uses(found.last_uses[i]) == uses(expected.last_uses[i])) << where << ", last use " << i;
    EXPECT_TRUE(found.entry.empty() && expected.entry.empty()) << where;
}

RingHistory by_cells(const ResolvedGraph& graph, ResourceId id, std::span<const RangeAccess> events,
                     const Schedule& order) {
    return track_resource(
        {.resource = id, .roles = {{&graph.resources[id], events}}, .graph = &graph, .order = &order});
}

TEST(TrackWhole, GivesTheHistoryOfTrackResource) {
    size_t usual = 0, others = 0, imports = 0, waiting = 0, concurrent = 0;
    for (uint32_t seed = 1; seed <= 300; ++seed) {
        const FramePlan plan = random_plan(seed, 60);
        const AttachmentTable ops = attachment_ops(plan.graph, plan.live, plan.schedule);
        const ScopeTable scopes = find_scopes(plan.graph, plan.schedule, ops);
        const AccessTable events = collect_accesses(plan.graph, plan.schedule, ops, scopes);
        WholeTracker tracker(plan.schedule);
        for (ResourceId id(0); id < events.size(); ++id) {
            const ResourceDecl& decl = plan.graph.resources[id];
            if (events[id].empty()) continue;
            const WholeHistory* found = tracker.track(id, decl, events[id]);
            (found != nullptr ? usual : others) += 1;
            if (found == nullptr) continue;
            imports += decl.import ? 1 : 0;
            const RingHistory expected = by_cells(plan.graph, id, events[id], plan.schedule);
            const std::string where = "seed " + std::to_string(seed) + ", \"" + decl.name + "\"";
            expect_same(found->history, expected.roles.front(), where);
            EXPECT_TRUE(found->dependencies == expected.dependencies) << where;
            EXPECT_EQ(found->concurrent, expected.concurrent) << where;
            waiting += found->dependencies.empty() ? 0 : 1;
            concurrent += found->concurrent ? 1 : 0;
        }
    }
    std::printf(
        "%zu resources are the usual case (%zu imports; %zu with waits between queues; %zu are used by "
        "several families at a time), %zu are not\n",
        usual, imports, waiting, concurrent, others);
    EXPECT_GT(usual, 1000u);
    EXPECT_GT(imports, 100u);
    EXPECT_GT(waiting, 500u);
    EXPECT_GT(concurrent, 100u);
    EXPECT_GT(others, 500u);
}

TEST(TrackWhole, TwoPortsOfAPassAreOneAccess) {
    GraphBuilder b;
    const ResourceId words = b.buffer("words");
    b.compute("make", {{"dst", words, Access::storage_write, {}, 0}});
    b.compute("change",
              {{"src", words, Access::storage_read, {}, 0}, {"dst", words, Access::storage_write, {}, 1}});
    const ResolvedGraph graph = b.build();
    const Schedule order = in_order(graph, {"make", "change"});
    const AccessTable events = collect_accesses(graph, order, {{}, {}}, {kNoId, kNoId});
    WholeTracker tracker(order);
    const WholeHistory* found = tracker.track(words, graph.resources[words], events[words]);
    ASSERT_NE(found, nullptr);
    ASSERT_EQ(found->history.barriers.size(), 2u);
    EXPECT_EQ(found->history.barriers[1].barrier.dst.access, access::kStorageRead | access::kStorageWrite);
    expect_same(found->history, by_cells(graph, words, events[words], order).roles.front(), "words");
}

}  // namespace
}  // namespace weft::test

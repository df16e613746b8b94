#include "graph/compile/link.h"

#include <gtest/gtest.h>

#include "tests/graph/samples/graph_builder.h"
#include "tests/graph/samples/hand_made.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

constexpr AccessState kExit{stage::kCopy, access::kTransferRead, Layout::transfer_src};

// Returns results of all stages of compile(), made by hand, for three images: `a` and `c` are imports, and
// `b` is kept from frame to frame. `c` is not live.
StageResults results() {
    GraphBuilder builder;
    const ResourceId a = builder.image("a"), b = builder.image("b"), c = builder.image("c");
    builder.import_as(a, {}, kExit);
    builder.import_as(c, {}, kExit);
    builder.ring(b, 0);
    StageResults r;
    r.graph = builder.build();
    r.graph.resources[0].import->family = 2;
    r.live = all_live(r.graph);
    r.live.live_resources[2] = 0;
    r.schedule.chosen = "by hand";
    r.sync.histories = HistoryTable(3);
    r.sync.histories.set(1, {.entry = {{kNoId, r.graph.resources[1].whole(), {0, 0, Layout::general}, 0}}});
    r.lifetimes.spans.resize(3);
    r.memory.sum_bytes = 5;
    r.barriers.emitted = 7;
    r.submissions.batches.resize(2);
    return r;
}

TEST(Link, TakesEveryStagesResult) {
    const FramePlan plan = link(results());
    EXPECT_EQ(plan.graph.resources.size(), 3u);
    EXPECT_EQ(plan.live.live_resources, (std::vector<uint8_t>{1, 1, 0}));
    EXPECT_EQ(plan.schedule.chosen, "by hand");
    EXPECT_EQ(plan.lifetimes.spans.size(), 3u);
    EXPECT_EQ(plan.memory.sum_bytes, 5u);
    EXPECT_EQ(plan.barriers.emitted, 7u);
    EXPECT_EQ(plan.submissions.batches.size(), 2u);
}

TEST(Link, TheBoundaryHoldsLiveImportsAndWhatOutlivesTheFrame) {
    const std::vector<BoundaryState> boundary = link(results()).boundary;
    ASSERT_EQ(boundary.size(), 2u) << "c is not live";
    EXPECT_EQ(boundary[0].resource, 0u);
    EXPECT_EQ(boundary[0].state, kExit);
    EXPECT_EQ(boundary[0].family, 2u);
    EXPECT_EQ(boundary[1].resource, 1u);
    EXPECT_EQ(boundary[1].state.layout, Layout::general);
}

}  // namespace
}  // namespace weft::test

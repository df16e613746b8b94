#include "graph/schedule/lifetimes.h"

#include <gtest/gtest.h>

#include "tests/graph/samples/graph_builder.h"
#include "tests/graph/samples/hand_made.h"

namespace weft::test {
namespace {

// Returns the first and last position of use, such as "0..3". If the schedule has several queues, adds the
// first and last position on each queue: "0..3 q1:0..3 q0:1..1". Returns "-" if there is no use.
std::string span_text(const LifetimeSpan& span) {
    if (span.first > span.last) return span.queues.empty() ? "-" : "- with queues";
    const auto range = [](uint32_t first, uint32_t last) {
        return std::to_string(first) + ".." + std::to_string(last);
    };
    std::string text = range(span.first, span.last);
    for (const QueueSpan& queue : span.queues)
        text += " q" + std::to_string(queue.queue) + ":" + range(queue.first, queue.last);
    return text;
}

// Returns a graph with four passes. `make` writes x, `middle` reads x and writes y, `idle` uses neither x nor
// y, and `end` reads both.
ResolvedGraph frame() {
    GraphBuilder b;
    const ResourceId x = b.buffer("x"), y = b.buffer("y"), z = b.buffer("z");
    b.compute("make", {{"dst", x, Access::storage_write, {}, 0}});
    b.compute("middle", {{"src", x, Access::storage_read, {}, 0}, {"dst", y, Access::storage_write, {}, 1}});
    b.compute("idle", {{"dst", z, Access::storage_write, {}, 0}});
    b.compute("end", {{"a", x, Access::storage_read, {}, 0}, {"b", y, Access::storage_read, {}, 1}});
    return b.build();
}

TEST(Lifetimes, SpanFromTheFirstUseToTheLast) {
    const ResolvedGraph graph = frame();
    const Lifetimes found =
        lifetimes(graph, all_live(graph), in_order(graph, {"make", "middle", "idle", "end"}));
    ASSERT_EQ(found.spans.size(), 3u);
    EXPECT_EQ(span_text(found.spans[resource_of(graph, "x")]), "0..3");
    EXPECT_EQ(span_text(found.spans[resource_of(graph, "y")]), "1..3");
    EXPECT_EQ(span_text(found.spans[resource_of(graph, "z")]), "2..2");
}

TEST(Lifetimes, EveryQueueHasItsOwnSpanInTheOrderOfFirstUse) {
    const ResolvedGraph graph = frame();
    const Lifetimes found =
        lifetimes(graph, all_live(graph), in_order(graph, {"make", "middle", "idle", "end"}, {1, 0, 1, 1}));
    EXPECT_EQ(span_text(found.spans[resource_of(graph, "x")]), "0..3 q1:0..3 q0:1..1");
    EXPECT_EQ(span_text(found.spans[resource_of(graph, "y")]), "1..3 q0:1..1 q1:3..3");
}

TEST(Lifetimes, OnlyLiveTransientsHaveOne) {
    ResolvedGraph graph = frame();
    graph.resources[resource_of(graph, "x")].lifetime = ResourceLifetime::imported;
    graph.resources[resource_of(graph, "y")].lifetime = ResourceLifetime::persistent;
    LiveGraph live = all_live(graph);
    live.live_resources[resource_of(graph, "z")] = 0;
    const Lifetimes found = lifetimes(graph, live, in_order(graph, {"make", "middle", "idle", "end"}));
    for (const LifetimeSpan& span : found.spans) EXPECT_EQ(span_text(span), "-");
}

}  // namespace
}  // namespace weft::test

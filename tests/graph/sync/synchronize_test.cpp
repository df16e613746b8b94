// Tests synchronize(), which computes the barriers and last uses of each resource, the dependencies between
// queues, and the rendering scopes. It does not consider resources that share memory.
#include "graph/sync/synchronize.h"

#include <gtest/gtest.h>

#include "graph/resolve/cull.h"
#include "tests/graph/samples/graph_builder.h"
#include "tests/graph/samples/hand_made.h"

namespace weft::test {
namespace {

// Returns one line for each barrier: the schedule position, the source state, ">" and the destination state.
// A state is stages:access:layout, such as "compute_shader:storage_write:general". "after" at the beginning
// means that the barrier is recorded after the pass. "from before" means that it waits for the frame before.
std::string barriers_text(std::span<const PlacedBarrier> barriers) {
    const auto state = [](const AccessState& s) {
        return stages_text(s.stages) + ":" + access_text(s.access) + ":" + layout_text(s.layout);
    };
    std::string text;
    for (const PlacedBarrier& placed : barriers)
        text += (placed.after ? "after " : "") + std::to_string(placed.position) +
                (placed.barrier.from_previous_frame ? " from before " : " ") + state(placed.barrier.src) +
                " > " + state(placed.barrier.dst) + "\n";
    return text;
}

std::vector<BarrierReason> reasons_of(std::span<const PlacedBarrier> barriers) {
    std::vector<BarrierReason> reasons;
    for (const PlacedBarrier& placed : barriers) reasons.push_back(placed.barrier.reason);
    return reasons;
}

// Returns a graph in which pass "make" writes an image and pass "look" samples the image.
ResolvedGraph make_and_look() {
    GraphBuilder b;
    const ResourceId image = b.image("image"), words = b.buffer("words");
    b.compute("make", {{"dst", image, Access::storage_write, {}, 0}});
    b.compute("look",
              {{"src", image, Access::sampled_read, {}, 0}, {"dst", words, Access::storage_write, {}, 1}});
    return b.build();
}

TEST(Synchronize, ATransientsHistoryIsATakeOverAndOneBarrierForEachHazard) {
    const ResolvedGraph graph = make_and_look();
    const SyncTable table =
        synchronize(graph, cull(graph), in_order(graph, {"make", "look"}), {{}, {}}, {kNoId, kNoId});
    const HistoryTable::Row image = table.histories[resource_of(graph, "image")];
    EXPECT_EQ(barriers_text(image.barriers),
              "0 none:none:undefined > compute_shader:storage_write:general\n"
              "1 compute_shader:storage_write:general > compute_shader:sampled_read:shader_read_only\n");
    EXPECT_EQ(reasons_of(image.barriers),
              (std::vector<BarrierReason>{BarrierReason::alias, BarrierReason::raw}));
    EXPECT_EQ(image.barriers[1].barrier.from, pass_of(graph, "make"));
    ASSERT_EQ(image.last_uses.size(), 1u);
    EXPECT_EQ(image.last_uses[0].position, 1u);
    EXPECT_EQ(image.last_uses[0].stages, stage::kComputeShader);
    EXPECT_EQ(image.last_uses[0].writes, access::kNone) << "the barrier before it has flushed the write";
    EXPECT_EQ(image.last_uses[0].pass, pass_of(graph, "look"));
    EXPECT_TRUE(image.entry.empty());
    EXPECT_TRUE(table.dependencies.empty());
    EXPECT_EQ(table.concurrent, (std::vector<uint8_t>{0, 0}));
}

TEST(Synchronize, AcrossQueuesASemaphoreWaitsAndABarrierChangesTheLayout) {
    const ResolvedGraph graph = make_and_look();
    const SyncTable table =
        synchronize(graph, cull(graph), in_order(graph, {"make", "look"}, {0, 1}), {{}, {}}, {kNoId, kNoId});
    const ResourceId image = resource_of(graph, "image");
    EXPECT_EQ(table.dependencies, (std::vector<QueueDependency>{{0, 1, false, image}}));
    EXPECT_EQ(barriers_text(table.histories[image].barriers),
              "0 none:none:undefined > compute_shader:storage_write:general\n"
              "1 compute_shader:none:general > compute_shader:sampled_read:shader_read_only\n");
}

TEST(Synchronize, ABufferAcrossQueuesNeedsTheSemaphoreOnly) {
    GraphBuilder b;
    const ResourceId words = b.buffer("words"), sum = b.buffer("sum");
    b.compute("make", {{"dst", words, Access::storage_write, {}, 0}});
    b.compute("look",
              {{"src", words, Access::storage_read, {}, 0}, {"dst", sum, Access::storage_write, {}, 1}});
    const ResolvedGraph graph = b.build();
    const SyncTable table =
        synchronize(graph, cull(graph), in_order(graph, {"make", "look"}, {0, 1}), {{}, {}}, {kNoId, kNoId});
    const ResourceId id = resource_of(graph, "words");
    EXPECT_EQ(table.dependencies, (std::vector<QueueDependency>{{0, 1, false, id}}));
    EXPECT_EQ(barriers_text(table.histories[id].barriers),
              "0 none:none:undefined > compute_shader:storage_write:undefined\n");
}

TEST(Synchronize, AnImageMovesBetweenFamiliesAndABufferIsConcurrent) {
    GraphBuilder b;
    const ResourceId image = b.image("image"), words = b.buffer("words");
    b.compute("make",
              {{"a", image, Access::storage_write, {}, 0}, {"b", words, Access::storage_write, {}, 1}});
    b.compute("look", {{"a", image, Access::storage_read, {}, 0}, {"b", words, Access::storage_read, {}, 1}});
    const ResolvedGraph graph = b.build();
    Schedule order = in_order(graph, {"make", "look"}, {0, 1});
    order.queues[1].family = 1;
    const SyncTable table = synchronize(graph, cull(graph), order, {{}, {}}, {kNoId, kNoId});
    const std::span<const PlacedBarrier> barriers = table.histories[resource_of(graph, "image")].barriers;
    EXPECT_EQ(reasons_of(barriers),
              (std::vector<BarrierReason>{BarrierReason::alias, BarrierReason::release_queue,
                                          BarrierReason::acquire_queue}));
    EXPECT_EQ(barriers_text(barriers),
              "0 none:none:undefined > compute_shader:storage_write:general\n"
              "after 0 compute_shader:storage_write:general > none:none:general\n"
              "1 compute_shader:none:general > compute_shader:storage_read:general\n");
    EXPECT_EQ(barriers[1].barrier.src_family, 0u);
    EXPECT_EQ(barriers[1].barrier.dst_family, 1u);
    EXPECT_EQ(table.concurrent[resource_of(graph, "image")], 0);
    EXPECT_EQ(table.concurrent[resource_of(graph, "words")], 1);
}

// Returns a graph with three passes: "fill" writes the buffer `words`, and "first" and "second" draw on the
// same image. If `needs_words` is true, "second" also reads `words`.
ResolvedGraph two_layers(bool needs_words) {
    GraphBuilder b;
    const ResourceId target = b.image("target"), words = b.buffer("words");
    b.compute("fill", {{"dst", words, Access::storage_write, {}, 0}});
    b.pass("first", PassKind::fullscreen, {{"color", target, Access::color_write, {}, kNoId}});
    std::vector<BuilderUse> uses{{"color", target, Access::color_read_write, {}, kNoId}};
    if (needs_words) uses.push_back({"words", words, Access::storage_read, {}, 0});
    b.pass("second", PassKind::fullscreen, uses);
    return b.build();
}

TEST(Synchronize, ACandidateThatNoBarrierDividesKeepsItsScope) {
    const AttachmentTable ops{{}, {{0, LoadOp::clear, StoreOp::store}}, {{0, LoadOp::load, StoreOp::store}}};
    for (const bool divided : {false, true}) {
        const ResolvedGraph graph = two_layers(divided);
        const SyncTable table = synchronize(graph, cull(graph), in_order(graph, {"fill", "first", "second"}),
                                            ops, {kNoId, kNoId, 1});
        EXPECT_EQ(table.scopes, (ScopeTable{kNoId, kNoId, divided ? Position() : Position(1)}));
        const std::span<const PlacedBarrier> target = table.histories[resource_of(graph, "target")].barriers;
        ASSERT_EQ(target.size(), divided ? 2u : 1u);
        EXPECT_EQ(target[0].position, 1u);
        if (!divided) continue;
        EXPECT_EQ(target[1].barrier.reason, BarrierReason::raw);
    }
}

TEST(Synchronize, ARingIsFoundAsTheFrameBeforeLeftTheNextYoungerRole) {
    GraphBuilder b;
    const ResourceId color = b.image("color");
    const std::vector<ResourceId> roles = b.ring(color, 1);
    b.compute("blend", {{"past", roles[1], Access::sampled_read, {}, 0},
                        {"dst", color, Access::storage_write, {}, 1}});
    const ResolvedGraph graph = b.build();
    const SyncTable table = synchronize(graph, cull(graph), in_order(graph, {"blend"}), {{}}, {kNoId});
    const HistoryTable::Row now = table.histories[resource_of(graph, "color")];
    const HistoryTable::Row past = table.histories[resource_of(graph, "color[-1]")];
    EXPECT_EQ(barriers_text(now.barriers),
              "0 from before compute_shader:none:undefined > compute_shader:storage_write:general\n");
    EXPECT_EQ(barriers_text(past.barriers),
              "0 from before compute_shader:storage_write:general > "
              "compute_shader:sampled_read:shader_read_only\n");
    ASSERT_EQ(now.entry.size(), 1u);
    ASSERT_EQ(past.entry.size(), 1u);
    EXPECT_EQ(now.entry[0].state.layout, Layout::shader_read_only);
    EXPECT_EQ(past.entry[0].state.layout, Layout::general);
}

TEST(Synchronize, AnAfterEdgeBecomesADependencyBetweenQueues) {
    GraphBuilder b;
    const ResourceId x = b.buffer("x"), y = b.buffer("y");
    b.compute("one", {{"dst", x, Access::storage_write, {}, 0}});
    b.compute("two", {{"dst", y, Access::storage_write, {}, 0}});
    b.after("one", "two");
    const ResolvedGraph graph = b.build();
    EXPECT_TRUE(synchronize(graph, cull(graph), in_order(graph, {"one", "two"}), {{}, {}}, {kNoId, kNoId})
                    .dependencies.empty());
    EXPECT_EQ(
        synchronize(graph, cull(graph), in_order(graph, {"one", "two"}, {0, 1}), {{}, {}}, {kNoId, kNoId})
            .dependencies,
        (std::vector<QueueDependency>{{0, 1, false, kNoId}}));
}

}  // namespace
}  // namespace weft::test

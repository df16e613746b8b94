#include "graph/schedule/attachment_ops.h"

#include <gtest/gtest.h>

#include "graph/plan/plan_names.h"
#include "tests/graph/samples/graph_builder.h"
#include "tests/graph/samples/hand_made.h"

namespace weft::test {
namespace {

// Returns the load and store operations of all attachments of the pass at this position. Example for two
// attachments: "clear/store load/none".
std::string ops_at(const AttachmentTable& table, Position position) {
    std::string text;
    for (const AttachmentOps& ops : table[position])
        text += (text.empty() ? "" : " ") + std::string(enum_name(ops.load)) + "/" + enum_name(ops.store);
    return text;
}

// Builds a graph with three passes: "first" draws on `target`, "second" draws on top of this result, and
// "look" samples the final result.
struct Layers {
    GraphBuilder builder;
    ResourceId target = builder.image("target");

    Layers() {
        builder.pass("first", PassKind::fullscreen, {{"color", target, Access::color_write, {}, kNoId}});
        builder.pass("second", PassKind::fullscreen,
                     {{"color", target, Access::color_read_write, {}, kNoId}});
        builder.compute("look", {{"src", target, Access::sampled_read, {}, 0}});
    }
};

TEST(AttachmentOps, AFirstWriteClearsAndALaterOneLoads) {
    const ResolvedGraph graph = Layers().builder.build();
    const AttachmentTable table =
        attachment_ops(graph, all_live(graph), in_order(graph, {"first", "second", "look"}));
    ASSERT_EQ(table.size(), 3u);
    EXPECT_EQ(ops_at(table, 0), "clear/store");
    EXPECT_EQ(ops_at(table, 1), "load/store");
    EXPECT_EQ(ops_at(table, 2), "");
}

TEST(AttachmentOps, AWriteOfEveryTexelNeedsNoClear) {
    ResolvedGraph graph = Layers().builder.build();
    graph.passes[pass_of(graph, "first")].colors.front().covers = true;
    // Although the pass covers every texel, it reads the previous content, so the attachment must be loaded.
    graph.passes[pass_of(graph, "second")].colors.front().covers = true;
    const AttachmentTable table =
        attachment_ops(graph, all_live(graph), in_order(graph, {"first", "second", "look"}));
    EXPECT_EQ(ops_at(table, 0), "dont_care/store");
    EXPECT_EQ(ops_at(table, 1), "load/store");
}

TEST(AttachmentOps, ContentThatNoLivePassReadsIsNotStored) {
    const ResolvedGraph graph = Layers().builder.build();
    LiveGraph live = all_live(graph);
    live.live_passes[pass_of(graph, "look")] = 0;
    const AttachmentTable table = attachment_ops(graph, live, in_order(graph, {"first", "second"}));
    EXPECT_EQ(ops_at(table, 0), "clear/store");
    EXPECT_EQ(ops_at(table, 1), "load/dont_care");
}

TEST(AttachmentOps, ContentThatOutlivesTheFrameIsStored) {
    for (const bool import : {false, true}) {
        Layers layers;
        if (import)
            layers.builder.import_as(layers.target, {}, {});
        else
            layers.builder.ring(layers.target, 0);
        const ResolvedGraph graph = layers.builder.build();
        LiveGraph live = all_live(graph);
        live.live_passes[pass_of(graph, "look")] = 0;
        const AttachmentTable table = attachment_ops(graph, live, in_order(graph, {"first", "second"}));
        EXPECT_EQ(ops_at(table, 1), "load/store") << (import ? "import" : "kept");
    }
}

TEST(AttachmentOps, OnlyAReadOfTheSameRangeKeepsIt) {
    GraphBuilder b;
    const ResourceId target = b.image("target", Format::r32u, 16, 2);
    b.pass("mip0", PassKind::fullscreen, {{"color", target, Access::color_write, one_cell(0), kNoId}});
    b.pass("mip1", PassKind::fullscreen, {{"color", target, Access::color_write, one_cell(1), kNoId}});
    b.compute("look", {{"src", target, Access::sampled_read, one_cell(1), 0}});
    const ResolvedGraph graph = b.build();
    const AttachmentTable table =
        attachment_ops(graph, all_live(graph), in_order(graph, {"mip0", "mip1", "look"}));
    EXPECT_EQ(ops_at(table, 0), "clear/dont_care");
    EXPECT_EQ(ops_at(table, 1), "clear/store");
}

TEST(AttachmentOps, ColoursComeFirstAndTestedDepthIsNotStored) {
    GraphBuilder b;
    const ResourceId z = b.image("z", Format::d32f), color = b.image("color");
    b.pass("prepass", PassKind::raster, {{"depth", z, Access::depth_write, {}, kNoId}});
    b.pass("draw", PassKind::raster,
           {{"depth", z, Access::depth_read, {}, kNoId}, {"color", color, Access::color_write, {}, kNoId}});
    b.compute("look", {{"src", color, Access::sampled_read, {}, 0}});
    const ResolvedGraph graph = b.build();
    const AttachmentTable table =
        attachment_ops(graph, all_live(graph), in_order(graph, {"prepass", "draw", "look"}));
    EXPECT_EQ(ops_at(table, 0), "clear/store");
    EXPECT_EQ(ops_at(table, 1), "clear/store load/none");
    EXPECT_EQ(table[1][0].use, 1u);
    EXPECT_EQ(table[1][1].use, 0u);
}

}  // namespace
}  // namespace weft::test

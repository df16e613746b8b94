// Tests find_scopes(), which finds passes that could share a rendering scope. Also tests undivided() and
// within_batches(), which divide scopes at barriers and at the beginnings of batches.
#include <gtest/gtest.h>

#include "graph/sync/scopes.h"
#include "tests/graph/samples/graph_builder.h"
#include "tests/graph/samples/hand_made.h"

namespace weft::test {
namespace {

const AttachmentOps kLoads{0, LoadOp::load, StoreOp::store};
const AttachmentOps kClears{0, LoadOp::clear, StoreOp::store};

// Returns a graph in which the passes "first", "second" and "third" draw on the same image. Pass "far" writes
// a buffer and does not use the image.
ResolvedGraph layers() {
    GraphBuilder b;
    const ResourceId target = b.image("target"), words = b.buffer("words");
    b.pass("first", PassKind::fullscreen, {{"color", target, Access::color_write, {}, kNoId}});
    for (const char* name : {"second", "third"})
        b.pass(name, PassKind::fullscreen, {{"color", target, Access::color_read_write, {}, kNoId}});
    b.compute("far", {{"dst", words, Access::storage_write, {}, 0}});
    return b.build();
}

ScopeTable scopes_of_layers(const ResolvedGraph& graph) {
    return find_scopes(graph, in_order(graph, {"first", "second", "third"}), {{kClears}, {kLoads}, {kLoads}});
}

TEST(FindScopes, APassContinuesTheOneThatDrewTheSameRightBeforeIt) {
    EXPECT_EQ(scopes_of_layers(layers()), (ScopeTable{kNoId, 0, 1}));
}

TEST(FindScopes, AClearBeginsAnother) {
    const ResolvedGraph graph = layers();
    EXPECT_EQ(
        find_scopes(graph, in_order(graph, {"first", "second", "third"}), {{kClears}, {kClears}, {kLoads}}),
        (ScopeTable{kNoId, kNoId, 1}));
}

TEST(FindScopes, OnlyPassesOfTheSameQueueComeBetween) {
    const ResolvedGraph graph = layers();
    const std::vector<std::string> passes{"first", "far", "second"};
    const AttachmentTable ops{{kClears}, {}, {kLoads}};
    EXPECT_EQ(find_scopes(graph, in_order(graph, passes), ops), (ScopeTable{kNoId, kNoId, kNoId}));
    EXPECT_EQ(find_scopes(graph, in_order(graph, passes, {0, 1, 0}), ops), (ScopeTable{kNoId, kNoId, 0}));
}

TEST(FindScopes, ExtentResolveAndFrameSlicesMustAgree) {
    ResolvedGraph graph = layers();
    PassDecl& second = graph.passes[pass_of(graph, "second")];
    second.render_extent.width /= 2;
    EXPECT_EQ(scopes_of_layers(graph), (ScopeTable{kNoId, kNoId, kNoId})) << "extent";
    graph = layers();
    graph.passes[pass_of(graph, "third")].colors.front().resolve_use = 0;
    EXPECT_EQ(scopes_of_layers(graph), (ScopeTable{kNoId, 0, kNoId})) << "resolve";
    graph = layers();
    graph.passes[pass_of(graph, "third")].frame_slices = 2;
    EXPECT_EQ(scopes_of_layers(graph), (ScopeTable{kNoId, 0, kNoId})) << "runs in some frames only";
}

TEST(FindScopes, APassThatAlsoSamplesItsTargetStandsAlone) {
    GraphBuilder b;
    const ResourceId target = b.image("target");
    b.pass("first", PassKind::fullscreen, {{"color", target, Access::color_write, {}, kNoId}});
    b.pass("second", PassKind::fullscreen,
           {{"color", target, Access::color_read_write, {}, kNoId},
            {"src", target, Access::sampled_read, {}, 0}});
    const ResolvedGraph graph = b.build();
    EXPECT_EQ(find_scopes(graph, in_order(graph, {"first", "second"}), {{kClears}, {kLoads}}),
              (ScopeTable{kNoId, kNoId}));
}

TEST(FindScopes, ABarrierBeforeAPassOrBehindTheOneBeforeItDivides) {
    const ScopeTable all{kNoId, 0, 1, 2};
    const std::vector<PlacedBarrier> before{{1, false, {}}}, behind{{2, true, {}}};
    const std::vector<PlacedBarrier> epilogue{{kEpiloguePosition, false, {}}};
    EXPECT_EQ(undivided(all, {}), all);
    EXPECT_EQ(undivided(all, epilogue), all);
    EXPECT_EQ(undivided(all, before), (ScopeTable{kNoId, kNoId, 1, 2}));
    EXPECT_EQ(undivided(all, behind), (ScopeTable{kNoId, 0, 1, kNoId}));
}

TEST(FindScopes, ABatchBeginsAScope) {
    SubmissionPlan plan;
    plan.batches.resize(3);
    plan.batches[0].positions = {0, 1};
    plan.batches[1].positions = {2, 3};
    EXPECT_EQ(within_batches({kNoId, 0, 1, 2}, plan), (ScopeTable{kNoId, 0, kNoId, 2}));
}

}  // namespace
}  // namespace weft::test

#include <gtest/gtest.h>

#include "graph/resolve/cull.h"
#include "tests/graph/samples/graph_builder.h"

namespace weft::test {
namespace {

// Returns a graph with two chains: make → shade → the output, and make → ao → blur. No pass reads the output
// of blur.
ResolvedGraph frame() {
    GraphBuilder b;
    const ResourceId gbuffer = b.image("gbuffer"), ssao = b.image("ssao"), blurred = b.image("blurred");
    const ResourceId output = b.image("output");
    b.import_as(output, {}, {stage::kCopy, access::kTransferRead, Layout::transfer_src});
    b.set_output(output);
    b.compute("make", {{"dst", gbuffer, Access::storage_write, {}, kNoId}});
    b.compute("ao", {{"src", gbuffer, Access::sampled_read, {}, kNoId},
                     {"dst", ssao, Access::storage_write, {}, kNoId}});
    b.compute("blur", {{"src", ssao, Access::sampled_read, {}, kNoId},
                       {"dst", blurred, Access::storage_write, {}, kNoId}});
    b.compute("shade", {{"src", gbuffer, Access::sampled_read, {}, kNoId},
                        {"dst", output, Access::storage_write, {}, kNoId}});
    b.after("blur", "shade");
    return b.build();
}

size_t id(const ResolvedGraph& graph, const char* name) {
    return find_pass(graph, name);
}

TEST(Cull, KeepsWhatTheOutputNeedsAndNothingElse) {
    const ResolvedGraph graph = frame();
    const LiveGraph live = cull(graph);
    EXPECT_TRUE(live.live_passes[id(graph, "make")]);
    EXPECT_TRUE(live.live_passes[id(graph, "shade")]);
    EXPECT_FALSE(live.live_passes[id(graph, "ao")]);
    EXPECT_FALSE(live.live_passes[id(graph, "blur")]) << "`after` orders, it keeps nothing alive";
    EXPECT_FALSE(live.live_resources[find_resource(graph, "ssao")]);
}

TEST(Cull, SaysWhy) {
    const ResolvedGraph graph = frame();
    const LiveGraph live = cull(graph);
    EXPECT_EQ(live.reasons[id(graph, "blur")], CullReason::unused_output);
    EXPECT_EQ(live.details[id(graph, "blur")], "no pass reads \"blurred\"");
    EXPECT_EQ(live.reasons[id(graph, "ao")], CullReason::upstream_culled);
    EXPECT_EQ(live.details[id(graph, "ao")], "\"ssao\" is read only by \"blur\", which is culled too");
    EXPECT_EQ(live.details[id(graph, "make")], "");
}

TEST(Cull, SideEffectsAreRoots) {
    ResolvedGraph graph = frame();
    graph.passes[id(graph, "blur")].side_effect = true;
    const LiveGraph live = cull(graph);
    EXPECT_TRUE(live.live_passes[id(graph, "blur")]);
    EXPECT_TRUE(live.live_passes[id(graph, "ao")]);
}

TEST(Cull, RetainsOnlySharedResourcesThatNoPassUses) {
    ResolvedGraph graph = frame();
    const ResourceId ssao = find_resource(graph, "ssao"), gbuffer = find_resource(graph, "gbuffer");
    const std::vector<std::string> names{"ssao", "gbuffer", "blurred", "gone"};
    graph.resources[ssao].shared = graph.resources[gbuffer].shared = true;
    const LiveGraph live = cull(graph, false, names);
    EXPECT_TRUE(live.retained[ssao]);
    EXPECT_TRUE(live.live_resources[ssao]);
    EXPECT_FALSE(live.retained[gbuffer]) << "a live pass uses it";
    EXPECT_FALSE(live.live_resources[find_resource(graph, "blurred")]) << "it is not shared";
    EXPECT_FALSE(live.live_passes[id(graph, "ao")]);
}

TEST(Cull, KeepAllKeepsAll) {
    const ResolvedGraph graph = frame();
    for (const uint8_t pass : cull(graph, true).live_passes) EXPECT_TRUE(pass);
}

}  // namespace
}  // namespace weft::test

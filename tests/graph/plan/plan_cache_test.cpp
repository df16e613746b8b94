// An unchanged graph is not compiled again; a change of any input of compile() causes a new compilation.
#include "graph/plan/plan_cache.h"

#include <gtest/gtest.h>

#include "tests/graph/samples/random_graph.h"

namespace weft::test {
namespace {

TEST(PlanCache, GivesTheSamePlanForTheSameGraph) {
    const ResolvedGraph graph = random_graph(3);
    const MemoryNeeds needs = content_needs(graph);
    PlanCache cache;
    int compiled = 0;
    CompileOptions options;
    options.stage_over = [&](const char* stage) { compiled += std::string(stage) == "link" ? 1 : 0; };
    const FramePlan& plan = cache.get(graph, needs, options);
    EXPECT_EQ(&cache.get(graph, needs, options), &plan);
    EXPECT_EQ(&cache.get(random_graph(3), needs, options), &plan) << "content counts, not where it is";
    EXPECT_EQ(compiled, 1);
    EXPECT_EQ(plan.hash, compile(graph, needs, {}).hash);
    EXPECT_EQ(cache.find(compile_hash(graph, needs, options)), &plan);
    EXPECT_EQ(cache.find("no such hash"), nullptr);
}

TEST(PlanCache, NoticesWhateverCompileReads) {
    const ResolvedGraph graph = random_graph(3);
    const MemoryNeeds needs = content_needs(graph);
    const std::string hash = compile_hash(graph, needs, {});
    ResolvedGraph renamed = graph;
    renamed.passes[1].name += "x";
    EXPECT_NE(compile_hash(renamed, needs, {}), hash);
    EXPECT_NE(compile_hash(graph, content_needs(graph, 64), {}), hash);
    CompileOptions options;
    options.granularity_bytes = 65536;
    EXPECT_NE(compile_hash(graph, needs, options), hash);
    options = {};
    options.keep_all_passes = true;
    EXPECT_NE(compile_hash(graph, needs, options), hash);
    options = {};
    options.queues.push_back({QueueKind::compute, 1});
    EXPECT_NE(compile_hash(graph, needs, options), hash);
    ResolvedGraph moved = graph;
    moved.passes[0].loc = {0, 12, 3, 1};
    EXPECT_EQ(compile_hash(moved, needs, {}), hash);
}

// Texts longer than the buffer of the hash function, and texts across the buffer's boundaries.
TEST(PlanCache, LongNamesAreHashedWhole) {
    ResolvedGraph graph = random_graph(3);
    graph.passes[0].shader = std::string(10000, 'a');
    const std::string hash = compile_hash(graph, {}, {});
    for (const size_t at : {size_t{0}, size_t{4095}, size_t{4096}, size_t{9999}}) {
        ResolvedGraph other = graph;
        other.passes[0].shader[at] = 'b';
        EXPECT_NE(compile_hash(other, {}, {}), hash) << at;
    }
    for (size_t length = 4000; length < 4200; ++length) {
        ResolvedGraph other = graph;
        other.passes[0].shader.assign(length, 'a');
        const std::string first = compile_hash(other, {}, {});
        other.passes[0].shader.back() = 'b';
        EXPECT_NE(compile_hash(other, {}, {}), first) << length;
    }
}

}  // namespace
}  // namespace weft::test

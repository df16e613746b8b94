// Tests that equal plans have equal hashes, and that a change of any field changes the hash. Only places in
// the graph file (line and column) do not count.
#include <gtest/gtest.h>

#include <string>

#include "tests/graph/samples/random_graph.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

FramePlan some_plan() {
    const ResolvedGraph graph = random_graph(3);
    return compile(graph, content_needs(graph), {});
}

TEST(PlanHash, IsTheSameForTheSamePlan) {
    const std::string hash = plan_hash(some_plan());
    EXPECT_EQ(plan_hash(some_plan()), hash);
    EXPECT_EQ(hash.size(), 32u);
}

TEST(PlanHash, NoticesEveryFieldButProvenance) {
    const FramePlan plan = some_plan();
    const std::string hash = plan_hash(plan);
    FramePlan other = plan;
    other.graph.passes[1].name += "x";
    EXPECT_NE(plan_hash(other), hash);
    other = plan;
    ++other.memory.heaps[0].size_bytes;
    EXPECT_NE(plan_hash(other), hash);
    other = plan;
    other.schedule.queues.push_back({QueueKind::compute, 1});
    EXPECT_NE(plan_hash(other), hash);
    other = plan;
    other.graph.passes[0].loc = {0, 12, 3, 1};
    EXPECT_EQ(plan_hash(other), hash);
}

// Hashes a name that is longer than the 4096-byte buffer of the hash function, and names that end close to
// the end of that buffer. A change of one letter must change the hash.
TEST(PlanHash, LongNamesAreHashedWhole) {
    FramePlan plan;
    plan.graph.passes.resize(1);
    std::string& name = plan.graph.passes[0].shader;
    name.assign(10000, 'a');
    const std::string hash = plan_hash(plan);
    for (const size_t at : {size_t{0}, size_t{4095}, size_t{4096}, size_t{9999}}) {
        name.assign(10000, 'a');
        name[at] = 'b';
        EXPECT_NE(plan_hash(plan), hash) << at;
    }
    for (size_t length = 3900; length < 4200; ++length) {
        name.assign(length, 'a');
        const std::string first = plan_hash(plan);
        name.back() = 'b';
        EXPECT_NE(plan_hash(plan), first) << length;
    }
}

}  // namespace
}  // namespace weft::test

// Tests that equal plans have equal hashes, and that changed plans have other hashes. plan_hash() ignores
// only ParamCost and the places in the graph file (line and column).
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

// Each change in this test must change exactly one of two hashes: structure_hash() or values_hash().
// is_value() returns true if the change leaves structure_hash() the same.
TEST(PlanHash, AMemberBelongsToTheStructureOrToTheValues) {
    FramePlan plan = some_plan();
    PassDecl& first = plan.graph.passes[0];
    first.params.resize(1), first.spec_values.resize(1), first.custom_params.resize(1);
    first.colors.resize(1), first.depth.emplace();
    plan.graph.params.resize(1);
    const std::string structure = structure_hash(plan), values = values_hash(plan.graph);
    const auto is_value = [&](const auto& change) {
        FramePlan other = plan;
        change(other.graph.passes[0], other);
        const bool same_structure = structure_hash(other) == structure;
        EXPECT_NE(same_structure, values_hash(other.graph) == values);
        return same_structure;
    };
    EXPECT_TRUE(is_value([](PassDecl& pass, FramePlan&) { pass.params[0].value[2] += 5; }));
    EXPECT_TRUE(is_value([](PassDecl& pass, FramePlan&) { pass.spec_values[0].bits += 5; }));
    EXPECT_TRUE(is_value([](PassDecl& pass, FramePlan&) { pass.custom_params[0].value += 5; }));
    EXPECT_TRUE(is_value([](PassDecl& pass, FramePlan&) { pass.colors[0].blend.write_mask ^= 1; }));
    EXPECT_TRUE(is_value([](PassDecl& pass, FramePlan&) { pass.depth->blend.write_mask ^= 1; }));
    EXPECT_TRUE(is_value([](PassDecl& pass, FramePlan&) { pass.state.stencil_back.reference += 5; }));
    EXPECT_TRUE(is_value([](PassDecl& pass, FramePlan&) { pass.culls_draws = !pass.culls_draws; }));
    EXPECT_TRUE(is_value([](PassDecl& pass, FramePlan&) { pass.flops += 5; }));
    EXPECT_TRUE(is_value([](PassDecl&, FramePlan& other) { other.graph.params[0].value += 5; }));
    EXPECT_FALSE(is_value([](PassDecl& pass, FramePlan&) { pass.params[0].offset_bytes += 8; }));
    EXPECT_FALSE(is_value([](PassDecl& pass, FramePlan&) { pass.colors[0].location += 3; }));
    EXPECT_FALSE(is_value([](PassDecl& pass, FramePlan&) { pass.groups[1] += 7; }));
    EXPECT_FALSE(is_value([](PassDecl&, FramePlan& other) { other.graph.params[0].name += "x"; }));
    EXPECT_FALSE(is_value([](PassDecl&, FramePlan& other) { ++other.memory.heaps[0].size_bytes; }));
}

// The hash function collects its input in a buffer of 4096 bytes. The test hashes a name that is longer than
// the buffer, and names that end close to the end of the buffer. A change of one letter must change the hash.
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

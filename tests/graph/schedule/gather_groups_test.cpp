#include "graph/schedule/gather_groups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/graph/samples/graph_builder.h"
#include "tests/graph/samples/hand_made.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

// Builds graphs whose passes share no resource, so that all edges come from after().
class Passes {
 public:
    // Adds a pass. `unit` is the unit of a round; kNoId: the pass belongs to no group.
    void add(const std::string& name, uint32_t unit = kNoId) {
        const ResourceId buffer = builder.buffer("of " + name);
        builder.pass(name, PassKind::clear, {{"dst", buffer, Access::clear_write, {}, kNoId}}).rest_unit =
            unit;
    }
    // Returns the graph with groups that have these numbers of rounds.
    [[nodiscard]] ResolvedGraph build(const std::vector<uint32_t>& rounds) const {
        ResolvedGraph graph = builder.build();
        for (const uint32_t count : rounds) {
            GroupDecl& group = graph.groups.emplace_back();
            group.name = "g" + std::to_string(graph.groups.size());
            group.first_unit = graph.rest_unit_count;
            group.rounds = count;
            graph.rest_unit_count += count;
        }
        return graph;
    }
    GraphBuilder builder;
};

std::string gathered(const ResolvedGraph& graph, const LiveGraph& live,
                     const std::vector<std::string>& order) {
    std::vector<PassId> ids;
    for (const std::string& name : order) ids.push_back(pass_of(graph, name));
    std::string text;
    for (const PassId pass : gather_groups(graph, schedule_problem(graph, live, content_needs(graph)), ids))
        text += (text.empty() ? "" : " ") + graph.passes[pass].name;
    return text;
}

TEST(GatherGroups, APassThatNothingOrdersStandsOutsideTheBlock) {
    Passes passes;
    passes.add("make0", 0);
    passes.add("make1", 1);
    passes.add("other");
    const ResolvedGraph graph = passes.build({2});
    EXPECT_EQ(gathered(graph, all_live(graph), {"make0", "other", "make1"}), "make0 make1 other");
    EXPECT_EQ(gathered(graph, all_live(graph), {"other", "make1", "make0"}), "other make0 make1");
}

TEST(GatherGroups, RoundsFollowOneAfterAnother) {
    Passes passes;
    for (const char* name : {"make", "store"})
        for (uint32_t round = 0; round < 2; ++round) passes.add(name + std::to_string(round), round);
    passes.builder.after("make0", "store0");
    passes.builder.after("make1", "store1");
    const ResolvedGraph graph = passes.build({2});
    EXPECT_EQ(gathered(graph, all_live(graph), {"make1", "make0", "store1", "store0"}),
              "make0 store0 make1 store1");
}

TEST(GatherGroups, TheBlockWaitsForWhatAnyOfItsPassesNeeds) {
    Passes passes;
    passes.add("make0", 0);
    passes.add("make1", 1);
    passes.add("source");
    passes.add("reader");
    passes.builder.after("source", "make1");
    passes.builder.after("make0", "reader");
    const ResolvedGraph graph = passes.build({2});
    EXPECT_EQ(gathered(graph, all_live(graph), {"make0", "reader", "source", "make1"}),
              "source make0 make1 reader");
}

TEST(GatherGroups, OrderThroughCulledPassesHolds) {
    Passes passes;
    passes.add("make0", 0);
    passes.add("make1", 1);
    passes.add("first");
    passes.add("last");
    passes.add("between");
    passes.builder.after("first", "between");
    passes.builder.after("between", "make1");
    passes.builder.after("make1", "last");
    const ResolvedGraph graph = passes.build({2});
    LiveGraph live = all_live(graph);
    live.live_passes[pass_of(graph, "between")] = 0;
    live.live_passes[pass_of(graph, "make1")] = 0;
    EXPECT_EQ(gathered(graph, live, {"make0", "first", "last"}), "first make0 last");
}

TEST(GatherGroups, AGroupWithoutLivePassesOrdersTheOthers) {
    Passes passes;
    passes.add("make", 0);
    passes.add("z");
    passes.add("a");
    passes.builder.after("z", "make");
    passes.builder.after("make", "a");
    const ResolvedGraph graph = passes.build({1});
    LiveGraph live = all_live(graph);
    live.live_passes[pass_of(graph, "make")] = 0;
    EXPECT_EQ(gathered(graph, live, {"z", "a"}), "z a");
}

// In a random graph, each edge leads to a pass with a higher number, and the passes of a group have numbers
// that follow each other. So there is an order in which no other pass stands between them.
TEST(GatherGroups, RandomGraphs) {
    for (uint32_t seed = 1; seed <= 200; ++seed) {
        std::mt19937 random(seed);
        Passes passes;
        std::vector<uint32_t> rounds;
        uint32_t unit = 0, count = 0;
        const auto add = [&](uint32_t of_unit) { passes.add(std::to_string(100 + count++), of_unit); };
        for (uint32_t part = 0; part < 6; ++part) {
            if (random() % 2 == 0) {
                add(kNoId);
                continue;
            }
            rounds.push_back(1 + random() % 3);
            for (uint32_t round = 0; round < rounds.back(); ++round, ++unit)
                for (uint32_t i = 0; i <= random() % 3; ++i) add(unit);
        }
        for (uint32_t to = 1; to < count; ++to)
            for (uint32_t i = 0; i < random() % 3; ++i)
                passes.builder.after(std::to_string(100 + random() % to), std::to_string(100 + to));
        const ResolvedGraph graph = passes.build(rounds);
        LiveGraph live = all_live(graph);
        for (uint8_t& is_live : live.live_passes) is_live = random() % 4 != 0 ? 1 : 0;
        const ScheduleProblem problem = schedule_problem(graph, live, content_needs(graph));
        const std::vector<PassId> order = gather_groups(graph, problem, backward_greedy_order(problem));
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::vector<Position> position(graph.passes.size(), kNoId);
        for (Position p(0); p < order.size(); ++p) position[order[p]] = p;
        for (PassId pass(0); pass < graph.passes.size(); ++pass)
            EXPECT_EQ(position[pass] != kNoId, live.live_passes[pass] != 0);
        for (const EdgeDecl& edge : graph.edges) {
            if (position[edge.from] == kNoId || position[edge.to] == kNoId) continue;
            EXPECT_LT(position[edge.from], position[edge.to]);
        }
        for (const GroupDecl& group : graph.groups) {
            std::vector<uint32_t> units;
            std::vector<Position> at;
            for (Position p(0); p < order.size(); ++p)
                if (const uint32_t u = graph.passes[order[p]].rest_unit; u != kNoId && group.has_unit(u))
                    units.push_back(u), at.push_back(p);
            EXPECT_TRUE(std::ranges::is_sorted(units));
            EXPECT_TRUE(at.empty() || at.back() - at.front() + 1 == at.size());
        }
    }
}

}  // namespace
}  // namespace weft::test

// Tests that compile() returns the time of each of its stages if the caller asks for the times.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/graph/samples/random_graph.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

TEST(StageTimes, NameEveryStageInOrderAndChangeNothing) {
    const ResolvedGraph graph = random_graph(3);
    const MemoryNeeds needs = content_needs(graph);
    std::vector<StageTime> times{{"left from before", 0}};
    const FramePlan plan = compile(graph, needs, {}, &times);
    std::string stages;
    for (const StageTime& time : times) {
        stages += time.stage + " ";
        EXPECT_GE(time.us, 0) << time.stage;
    }
    EXPECT_EQ(stages,
              "cull schedule attachment_ops find_scopes synchronize add_clocks lifetimes alias barriers "
              "submissions link ");
    EXPECT_EQ(plan_hash(plan), plan_hash(compile(graph, needs, {})));
}

}  // namespace
}  // namespace weft::test

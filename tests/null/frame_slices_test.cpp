// Tests passes that run only in some frames (`perFrame`). A plan must keep their results for the frames in
// between. The checker must reject a plan that loses these results.
#include <gtest/gtest.h>

#include "null/null_executor.h"
#include "tests/graph/samples/random_graph.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

CompileOptions several_queues(uint32_t seed) {
    CompileOptions options;
    options.queues = logical_queues({}, 1 + seed % 4);
    return options;
}

// Changes each pass that has no side effect and writes only persistent resources without history and without
// ranges of buffers: several passes overwrite such ranges, which is not allowed in different slices. The pass
// then runs in frame 0 and in the frames whose number modulo 3 equals its `frame_slice`. Returns the number
// of changed passes.
uint32_t spread_over_frames(ResolvedGraph& graph) {
    uint32_t count = 0;
    for (PassDecl& pass : graph.passes) {
        bool writes_any = false, all_stay = true;
        for (const UseDecl& use : pass.uses) {
            if (!writes(use.access)) continue;
            const ResourceDecl& decl = graph.resources[use.resource];
            writes_any = true;
            all_stay &=
                decl.lifetime == ResourceLifetime::persistent && decl.history == 0 && decl.cuts_bytes.empty();
        }
        if (!writes_any || !all_stay || pass.side_effect) continue;
        pass.frame_slices = 3;
        pass.frame_slice = count++ % 3;
    }
    return count;
}

TEST(FrameSlices, RandomFramesGiveWhatTheyMean) {
    uint32_t passes = 0;
    for (uint32_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        ResolvedGraph graph = random_graph(seed, all_features());
        passes += spread_over_frames(graph);
        const FramePlan plan = compile(graph, content_needs(graph), several_queues(seed));
        const Diagnostics faults = check_plan(plan);
        ASSERT_TRUE(faults.empty()) << to_text(faults.front());
        const NullRun wanted = run_reference(plan.graph, plan.live, 5);
        const NullRun found = run_null(plan, {5, seed, NullOrder::shuffled});
        const std::vector<std::string> different = differences(plan.graph, wanted, found);
        ASSERT_TRUE(different.empty()) << different.front();
    }
    std::printf("seeds 0..299: %u passes are sliced over frames\n", passes);
    EXPECT_GE(passes, 30u);
}

TEST(FrameSlices, ContentThatIsDroppedIsMissed) {
    uint32_t planted = 0;
    for (uint32_t seed = 0; seed < 300 && planted < 5; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        ResolvedGraph graph = random_graph(seed, all_features());
        if (spread_over_frames(graph) == 0) continue;
        FramePlan plan = compile(graph, content_needs(graph), {});
        bool dropped = false;
        for (PassStep& step : plan.barriers.steps) {
            for (BarrierDecl& barrier : step.barriers) {
                const ResourceDecl& decl = plan.graph.resources[barrier.resource];
                if (plan.graph.passes[step.pass].frame_slices == 0 || decl.kind != ResourceKind::image)
                    continue;
                barrier.src.layout = Layout::undefined;
                dropped = true;
            }
        }
        if (!dropped) continue;
        ++planted;
        EXPECT_FALSE(check_plan(plan).empty());
    }
    EXPECT_EQ(planted, 5u);
}

}  // namespace
}  // namespace weft::test

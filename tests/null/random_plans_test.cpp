// Tests that the compiler's plans of random frames give the expected results, even if the null executor runs
// the commands in the worst order that the synchronisation allows.
#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "null/null_executor.h"
#include "tests/graph/compile/naive_plan.h"
#include "tests/graph/samples/random_graph.h"
#include "tests/graph/samples/random_graph_coverage.h"
#include "tests/null/profile_plans.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

// Each entry: number of frames, seed, order.
const NullOptions kPlanOrders[] = {{3, 0, NullOrder::recorded},
                                   {3, 1, NullOrder::delayed},
                                   {3, 2, NullOrder::shuffled},
                                   {4, 3, NullOrder::shuffled}};

void expect_reference(const FramePlan& plan) {
    for (const NullOptions& options : kPlanOrders) {
        const NullRun wanted = run_reference(plan.graph, plan.live, options.frames);
        const NullRun found = run_null(plan, options);
        const std::vector<std::string> different = differences(plan.graph, wanted, found);
        if (different.empty()) continue;
        ADD_FAILURE() << different.front() << "\n" << (found.faults.empty() ? "" : found.faults.front());
        return;
    }
}

TEST(RandomPlans, GiveWhatTheGraphMeansOnOneQueue) {
    for (uint32_t seed = 0; seed < 150; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const ResolvedGraph graph = random_graph(seed);
        expect_reference(compile(graph, content_needs(graph), {}));
        expect_reference(naive_plan(graph));
        if (HasFailure()) return;
    }
}

// Expects that enough of the random graphs use each important feature, for example aliased memory. Otherwise
// the test would hardly test that feature.
void expect_shares(const GraphCoverage& coverage) {
    EXPECT_GE(coverage.alias_transitions * 2, coverage.graphs);
    for (const uint32_t count :
         {coverage.waits, coverage.history, coverage.ranges, coverage.repeats, coverage.conditionals})
        EXPECT_GE(count * 10, coverage.graphs * 3);
    EXPECT_GE(coverage.buffer_ranges * 5, coverage.graphs);
    EXPECT_GE(coverage.merged_scopes * 10, coverage.graphs);
    EXPECT_GE(coverage.carried * 50, coverage.graphs);
    EXPECT_GE(coverage.tables * 10, coverage.graphs);
    for (const uint32_t count :
         {coverage.arrays, coverage.layer_arrays, coverage.program_views, coverage.mirrors,
          coverage.cube_views, coverage.buffer_views, coverage.indirect_offsets, coverage.indirect_draws,
          coverage.draw_counts, coverage.reductions, coverage.anisotropic, coverage.levels, coverage.shared,
          coverage.files, coverage.scene_buffers})
        EXPECT_GE(count * 50, coverage.graphs) << coverage.text();
    EXPECT_GE(coverage.views * 10, coverage.graphs);
}

TEST(RandomPlans, GiveWhatTheGraphMeansWithAllFeaturesForAllProfiles) {
    const uint32_t graphs = extended() ? 10000 : 300;
    const ProfilePlans plans;
    ASSERT_EQ(plans.count(), 5u);
    GraphCoverage coverage;
    std::map<std::string, uint32_t> by_profile;
    uint32_t texts = 0, failures = 0;
    for (uint32_t seed = 0; seed < graphs && failures < 5; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const ProfilePlan made = plans.make(seed);
        coverage.add(made.plan, made.omitted);
        ++by_profile[made.profile];
        texts += made.from_text ? 1 : 0;
        const Diagnostics faults = check_plan(made.plan);
        EXPECT_TRUE(faults.empty()) << to_text(faults.front());
        expect_reference(made.plan);
        failures += HasFailure() ? 1 : 0;
    }
    std::cout << "seeds 0.." << graphs - 1 << ", " << coverage.text() << "; " << texts << " from texts";
    for (const auto& [profile, count] : by_profile) std::cout << ", " << count << " for " << profile;
    std::cout << "\n";
    expect_shares(coverage);
}

TEST(RandomPlans, TheNaivePlanGivesItToo) {
    for (uint32_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const FramePlan plan = naive_plan(random_graph(seed, all_features()));
        const Diagnostics faults = check_plan(plan);
        EXPECT_TRUE(faults.empty()) << to_text(faults.front());
        expect_reference(plan);
        if (HasFailure()) return;
    }
}

}  // namespace
}  // namespace weft::test

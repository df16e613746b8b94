// Tests the plan checker with mutants of plans. If a mutant gives wrong results in the null executor, then
// the checker must reject the mutant.
#include <gtest/gtest.h>

#include "tests/null/mutant_judge.h"
#include "tests/null/profile_plans.h"
#include "weft/check/check_plan.h"

namespace weft::test {
namespace {

TEST(PlanMutants, WhatTheNullExecutorBreaksTheCheckerCatches) {
    const uint32_t graphs = extended() ? 100 : 40;
    const uint32_t max_passes = extended() ? 60 : 20;
    const ProfilePlans plans;
    Tallies tallies;
    for (uint32_t seed = 0; seed < graphs; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::to_string(max_passes) + " passes");
        const FramePlan plan = plans.make(seed, max_passes).plan;
        ASSERT_TRUE(check_plan(plan).empty());
        judge_mutants(plan, extended() ? 4 : 8, tallies);
    }
    print(tallies);
    const Tally& removed = tallies.at(static_cast<size_t>(MutantKind::removed_barrier));
    EXPECT_GE(removed.caught * 100, removed.all * 95) << "too many barriers that nobody needs";
    const Tally& narrowed = tallies.at(static_cast<size_t>(MutantKind::narrowed_barrier));
    EXPECT_GE(narrowed.broken, 3u);
}

}  // namespace
}  // namespace weft::test

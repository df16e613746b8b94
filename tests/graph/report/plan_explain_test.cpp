// Tests that the answers of `weft explain`, the differences of diff_plans() and the text of plan_to_text()
// agree with random plans on one to four queues.
#include "weft/report/plan_explain.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/graph/samples/random_plan.h"
#include "weft/compile.h"
#include "weft/report/plan_diff.h"
#include "weft/report/plan_dump.h"

namespace weft::test {
namespace {

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string quoted(const std::string& name) {
    return "\"" + name + "\"";
}

constexpr uint32_t kSeeds = 24;

TEST(ExplainRandom, CulledIsWhoDoesNotRun) {
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
        const FramePlan plan = random_plan(seed, 25);
        for (PassId pass(0); pass < plan.graph.passes.size(); ++pass) {
            const Result<std::string> answer = explain_culled(plan, plan.graph.passes[pass].name);
            ASSERT_TRUE(answer.ok());
            EXPECT_EQ(has(*answer, " is not culled"), plan.live.live_passes[pass] != 0) << *answer;
            // For a live pass, the answer must give one of three reasons: another pass needs its result,
            // the pass writes the output, or the pass has a side effect.
            EXPECT_TRUE(!plan.live.live_passes[pass] || has(*answer, "needs its result") ||
                        has(*answer, "the output") || has(*answer, "side effect"))
                << *answer;
        }
    }
}

TEST(ExplainRandom, EveryBarrierBetweenTwoPassesIsFound) {
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
        const FramePlan plan = random_plan(seed, 25);
        for (const PassStep& step : plan.barriers.steps)
            for (const BarrierDecl& barrier : step.barriers) {
                if (barrier.from == kNoId) continue;
                const Result<std::string> answer = explain_barrier(plan, plan.graph.passes[barrier.from].name,
                                                                   plan.graph.passes[step.pass].name);
                ASSERT_TRUE(answer.ok());
                EXPECT_TRUE(has(*answer, "a barrier before " + quoted(plan.graph.passes[step.pass].name)))
                    << *answer;
                EXPECT_TRUE(has(*answer, plan.graph.resources[barrier.resource].name)) << *answer;
            }
    }
}

TEST(ExplainRandom, PairsWithoutABarrierGetAReason) {
    for (uint32_t seed = 1; seed <= 8; ++seed) {
        const FramePlan plan = random_plan(seed, 25);
        for (const PassDecl& a : plan.graph.passes)
            for (const PassDecl& b : plan.graph.passes) {
                const Result<std::string> answer = explain_barrier(plan, a.name, b.name);
                ASSERT_TRUE(answer.ok());
                EXPECT_TRUE(!has(*answer, "There is no barrier") || has(*answer, "\n  ") ||
                            has(*answer, "is culled"))
                    << *answer;
            }
    }
}

TEST(ExplainRandom, AliasIsWhatSharesBytes) {
    size_t shared = 0;
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
        const FramePlan plan = random_plan(seed, 25);
        for (const Placement& p : plan.memory.placements)
            for (const Placement& q : plan.memory.placements) {
                if (p.resource >= q.resource) continue;
                const bool same_bytes = p.heap == q.heap && p.offset_bytes < q.offset_bytes + q.size_bytes &&
                                        q.offset_bytes < p.offset_bytes + p.size_bytes;
                const Result<std::string> answer = explain_alias(plan, plan.graph.resources[p.resource].name,
                                                                 plan.graph.resources[q.resource].name);
                ASSERT_TRUE(answer.ok());
                EXPECT_EQ(has(*answer, "They share memory"), same_bytes) << *answer;
                shared += same_bytes ? 1 : 0;
            }
    }
    EXPECT_GT(shared, 100u);
}

TEST(ExplainRandom, WaitNamesEveryDependencyOfASubmission) {
    size_t waits = 0;
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
        const FramePlan plan = random_plan(seed, 25);
        for (const QueueDependency& d : plan.submissions.dependencies) {
            if (d.to >= plan.schedule.order.size() || d.from >= plan.schedule.order.size()) continue;
            const std::string from = plan.graph.passes[plan.schedule.order[d.from]].name;
            const Result<std::string> answer =
                explain_wait(plan, plan.graph.passes[plan.schedule.order[d.to]].name);
            ASSERT_TRUE(answer.ok());
            EXPECT_TRUE(has(*answer, "must not start before " + std::to_string(d.from) + " " + quoted(from)))
                << *answer;
            ++waits;
        }
    }
    EXPECT_GT(waits, 20u);
}

TEST(ExplainRandom, AResourceNamesAllItsUsers) {
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
        const FramePlan plan = random_plan(seed, 25);
        for (ResourceId id(0); id < plan.graph.resources.size(); ++id) {
            const Result<std::string> answer = explain_resource(plan, plan.graph.resources[id].name);
            ASSERT_TRUE(answer.ok());
            for (const PassDecl& pass : plan.graph.passes)
                for (const UseDecl& use : pass.uses)
                    EXPECT_TRUE(use.resource != id || has(*answer, quoted(pass.name))) << *answer;
        }
    }
}

TEST(DiffRandom, OfOneSeedIsNothingAndOfTwoIsWhatTheCountsSay) {
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
        const FramePlan a = random_plan(seed, 25), b = random_plan(seed + 1, 25);
        const PlanDiff none = diff_plans(a, random_plan(seed, 25));
        EXPECT_TRUE(none.same);
        EXPECT_TRUE(none.passes.changed.empty() && none.resources.changed.empty() && none.moved.empty());
        const PlanDiff diff = diff_plans(a, b);
        EXPECT_FALSE(diff.same);
        EXPECT_EQ(a.graph.passes.size() + diff.passes.added.size() - diff.passes.removed.size(),
                  b.graph.passes.size());
        EXPECT_EQ(a.graph.resources.size() + diff.resources.added.size() - diff.resources.removed.size(),
                  b.graph.resources.size());
        EXPECT_FALSE(plan_diff_to_text(diff).empty());
    }
}

// The first pass is moved behind all others. The diff must report only that one pass as moved.
TEST(DiffRandom, TheFewestMovesExplainANewOrder) {
    FramePlan a = random_plan(4, 25), b = a;
    ASSERT_GE(a.schedule.order.size(), 3u);
    std::rotate(b.schedule.order.begin(), b.schedule.order.begin() + 1, b.schedule.order.end());
    std::rotate(b.barriers.steps.begin(), b.barriers.steps.begin() + 1, b.barriers.steps.end());
    for (Position p(0); p < b.schedule.order.size(); ++p) b.schedule.position[b.schedule.order[p]] = p;
    const PlanDiff diff = diff_plans(a, b);
    ASSERT_EQ(diff.moved.size(), 1u);
    EXPECT_EQ(diff.moved[0].name, a.graph.passes[a.schedule.order[0]].name);
    EXPECT_EQ(diff.moved[0].from, 0u);
    EXPECT_EQ(diff.moved[0].to, a.schedule.order.size() - 1);
}

TEST(PlanDump, TextSpeaksOfQueuesAndOfWhatIsDoneOnce) {
    bool waits = false, prologue = false, afterwards = false;
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
        const std::string text = plan_to_text(random_plan(seed, 25));
        waits = waits || has(text, "    wait for queue ");
        prologue = prologue || has(text, "once, before the first frame");
        afterwards = afterwards || has(text, "    after the pass    barrier ");
    }
    EXPECT_TRUE(waits && prologue && afterwards);
}

}  // namespace
}  // namespace weft::test

// Tests plans of random texts whose program exports resources: the passes that write them run, the resources
// have memory of their own, and the program sees them in the declared state on one to three queues.
#include <gtest/gtest.h>

#include "null/null_executor.h"
#include "tests/graph/resolve/resolve_fixture.h"
#include "tests/graph/samples/random_text.h"
#include "tests/null/mutant_judge.h"
#include "tests/null/profile_plans.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

// Returns one or two transient resources that passes write, chosen by the seed.
std::map<std::string, ExportUse> choose_exports(const ResolvedGraph& graph, uint32_t seed) {
    std::vector<std::string> names;
    for (const PassDecl& pass : graph.passes)
        for (const UseDecl& use : pass.uses)
            if (writes(use.access) && graph.resources[use.resource].lifetime == ResourceLifetime::transient)
                names.push_back(graph.resources[use.resource].name);
    std::map<std::string, ExportUse> exports;
    for (uint32_t i = 0; i <= seed % 2 && !names.empty(); ++i)
        exports[names[(seed + 7 * i) % names.size()]] = {seed % 3 == 0 ? Access::copy_read
                                                                       : Access::sampled_read};
    return exports;
}

void expect_exports(const FramePlan& plan, const std::map<std::string, ExportUse>& exports) {
    for (const auto& [name, use] : exports) {
        const ResourceId id = find_resource(plan.graph, name);
        for (const Placement& placement : plan.memory.placements) EXPECT_NE(placement.resource, id) << name;
        EXPECT_NE(plan.graph.resources[id].import->exit.access, access::kNone) << name;
        for (PassId pass(0); pass < plan.graph.passes.size(); ++pass)
            for (const UseDecl& other : plan.graph.passes[pass].uses)
                EXPECT_TRUE(other.resource != id || !writes(other.access) || plan.live.live_passes[pass])
                    << plan.graph.passes[pass].name;
    }
}

TEST(ExportPlans, TheProgramSeesWhatTheFrameWrites) {
    const uint32_t seeds = extended() ? 1000 : 40;
    uint32_t made = 0;
    Tallies tallies;
    for (uint32_t seed = 0; seed < seeds; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const RandomText text = random_text(seed, fake_profile());
        const Result<ResolvedGraph> plain = resolve_text(text.text, text.params, fake_profile());
        ASSERT_TRUE(plain) << to_text(plain.errors());
        const auto exports = choose_exports(*plain, seed);
        const Result<ResolvedGraph> graph = resolve_text(text.text, text.params, fake_profile(), 64, exports);
        if (!graph) {
            // Outputs of passes with "rest" have no content in the frames in which these passes rest.
            for (const Diagnostic& fault : graph.errors()) EXPECT_EQ(fault.code, "W188") << to_text({fault});
            continue;
        }
        made += exports.empty() ? 0 : 1;
        CompileOptions options;
        options.queues = logical_queues({}, 1 + seed % 3);
        const FramePlan plan = compile(*graph, content_needs(*graph), options);
        EXPECT_TRUE(check_plan(plan).empty()) << to_text(check_plan(plan));
        expect_exports(plan, exports);
        const NullRun wanted = run_reference(plan.graph, plan.live);
        EXPECT_TRUE(differences(plan.graph, wanted, run_null(plan, {3, seed, NullOrder::shuffled})).empty());
        if (seed % 8 == 0) judge_mutants(plan, 8, tallies);
        if (HasFailure()) return;
    }
    EXPECT_GE(made * 2, seeds);
    print(tallies);
    for (const Tally& tally : tallies) EXPECT_EQ(tally.missed, 0u);
}

}  // namespace
}  // namespace weft::test

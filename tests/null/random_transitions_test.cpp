// Tests transitions between plans of random texts: after a change of the size, of the formats of kept
// resources, or of the parameters. The checker must accept each transition, and must find what is missing if
// a part of the transition is removed.
#include <gtest/gtest.h>

#include <iostream>
#include <utility>

#include "tests/graph/samples/random_text.h"
#include "tests/null/profile_plans.h"
#include "weft/check/check_transition.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

// Gives the images with history another format.
std::string with_other_formats(std::string text) {
    for (size_t at = text.find("_ring_"); at != std::string::npos; at = text.find("_ring_", at + 1)) {
        const size_t quote = text.find('"', at);
        for (const auto& [from, to] : {std::pair("rgba8", "rgba16f"), std::pair("rgba16f", "rgba8")}) {
            const std::string format = std::string("\": {\"format\": \"") + from + "\"";
            if (text.compare(quote, format.size(), format) != 0) continue;
            text.replace(quote, format.size(), std::string("\": {\"format\": \"") + to + "\"");
            break;
        }
    }
    return text;
}

struct TransitionCoverage {
    uint32_t transitions = 0, copied = 0, scaled = 0, converted = 0, cleared = 0, shared = 0;

    void add(const FramePlan& old_plan, const FramePlan& new_plan, const TransitionPlan& made) {
        ++transitions;
        cleared += static_cast<uint32_t>(made.cleared.size());
        for (const ContentCopy& copy : made.carried) {
            const ResourceDecl& from = old_plan.graph.resources[copy.from];
            const ResourceDecl& to = new_plan.graph.resources[copy.to];
            shared += copy.shared ? 1 : 0;
            copied += !copy.resample && !copy.shared ? 1 : 0;
            scaled += copy.resample && from.extent != to.extent ? 1 : 0;
            converted += copy.resample && from.format != to.format ? 1 : 0;
        }
    }
};

// Removes each part of the transition, one after another. Returns the number of parts. Parts whose absence
// the checker does not find are counted in `missed`.
uint32_t remove_parts(const FramePlan& old_plan, const FramePlan& new_plan, const TransitionPlan& made,
                      uint32_t& missed) {
    uint32_t removed = 0;
    const auto remove_from = [&](auto TransitionPlan::*list) {
        for (size_t i = 0; i < (made.*list).size(); ++i) {
            TransitionPlan wrong = made;
            (wrong.*list).erase((wrong.*list).begin() + static_cast<std::ptrdiff_t>(i));
            missed += check_transition(old_plan, new_plan, wrong).empty() ? 1 : 0;
            ++removed;
        }
    };
    remove_from(&TransitionPlan::carried);
    remove_from(&TransitionPlan::cleared);
    remove_from(&TransitionPlan::before_old);
    remove_from(&TransitionPlan::before);
    remove_from(&TransitionPlan::after);
    return removed;
}

// Returns all resources that keep their content and that passes write.
std::map<std::string, ExportUse> all_kept(const ResolvedGraph& graph) {
    std::map<std::string, ExportUse> exports;
    for (const PassDecl& pass : graph.passes)
        for (const UseDecl& use : pass.uses)
            if (writes(use.access) && graph.resources[use.resource].ring == use.resource)
                exports[graph.resources[use.resource].name] = {Access::copy_read};
    return exports;
}

TEST(RandomTransitions, AreCompleteAndNothingCanBeLeftOut) {
    const uint32_t seeds = extended() ? 5000 : 200;
    const ProfilePlans plans;
    TransitionCoverage coverage;
    uint32_t removed = 0, missed = 0, exported = 0;
    for (uint32_t seed = 0; seed < seeds; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const DeviceProfile& profile = plans.profile(seed);
        const RandomText text = random_text(seed, profile);
        const std::string changed = seed % 2 == 1 ? with_other_formats(text.text) : text.text;
        std::map<std::string, double> params = text.params;
        if (seed % 4 == 2) params["p0"] = params.contains("p0") ? 1 - params["p0"] : 1;
        const uint32_t to_px = seed % 4 == 0 ? 48 : 64;
        Result<ResolvedGraph> from = resolve_text(text.text, text.params, profile),
                              to = resolve_text(changed, params, profile, to_px);
        ASSERT_TRUE(from) << to_text(from.errors());
        // In some plans, the program reads the kept resources between frames, in another layout.
        if (const auto exports = all_kept(*from); seed % 3 == 0 && to) {
            if (seed % 2 == 0) from = resolve_text(text.text, text.params, profile, 64, exports);
            ASSERT_TRUE(from) << to_text(from.errors());
            if (seed % 9 < 6) to = resolve_text(changed, params, profile, to_px, all_kept(*to));
            exported += exports.empty() ? 0 : 1;
        }
        // Not every pass accepts the other format, for example a copy to an image of the old format.
        if (!to && seed % 2 == 1) continue;
        ASSERT_TRUE(to) << to_text(to.errors()) << changed;
        const uint32_t queues = 1 + seed / 5 % 3;
        const FramePlan old_plan =
            compile(*from, profile_needs(*from, profile), compile_options(profile, queues));
        const FramePlan new_plan =
            compile(*to, profile_needs(*to, profile), compile_options(profile, queues));
        const TransitionPlan made = transition(old_plan, new_plan);
        const Diagnostics faults = check_transition(old_plan, new_plan, made);
        ASSERT_TRUE(faults.empty()) << to_text(faults) << text.text;
        coverage.add(old_plan, new_plan, made);
        removed += remove_parts(old_plan, new_plan, made, missed);
    }
    std::cout << "seeds 0.." << seeds - 1 << ": " << coverage.transitions << " transitions, "
              << coverage.copied << " copied, " << coverage.scaled << " scaled, " << coverage.converted
              << " converted, " << coverage.cleared << " cleared, " << coverage.shared << " shared; "
              << removed << " parts removed, " << missed << " missed\n";
    EXPECT_EQ(missed, 0u);
    for (const uint32_t count :
         {coverage.copied, coverage.scaled, coverage.converted, coverage.cleared, coverage.shared})
        EXPECT_GE(count * 50, seeds);
    EXPECT_GE(coverage.transitions * 10, seeds * 8);
    EXPECT_GE(exported * 10, seeds);
}

}  // namespace
}  // namespace weft::test

#include "tests/null/profile_plans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/graph/samples/random_graph.h"
#include "tests/graph/samples/random_text.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

namespace fs = std::filesystem;

FramePlan plan_for(const ResolvedGraph& graph, const DeviceProfile& profile, uint32_t queues) {
    return compile(graph, profile_needs(graph, profile), compile_options(profile, queues));
}

}  // namespace

ProfilePlans::ProfilePlans() {
    for (const fs::directory_entry& entry :
         fs::directory_iterator(fs::path(WEFT_SOURCE_DIR) / "framework/profiles")) {
        std::ifstream in(entry.path(), std::ios::binary);
        std::ostringstream text;
        text << in.rdbuf();
        Result<DeviceProfile> profile = parse_profile(text.str(), entry.path().string());
        if (profile)
            profiles_.emplace_back(entry.path().stem().string(), std::move(*profile));
        else
            ADD_FAILURE() << to_text(profile.errors());
    }
    std::sort(profiles_.begin(), profiles_.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
}

ProfilePlan ProfilePlans::make(uint32_t seed, uint32_t max_passes) const {
    // Even seeds make texts, odd seeds make graphs in memory. seed / 2 selects the profile and the number of
    // queues, so both kinds get all combinations.
    const auto& [name, profile] = profiles_[seed / 2 % profiles_.size()];
    const auto queues = static_cast<uint32_t>(1 + seed / 2 / profiles_.size() % 4);
    ProfilePlan made;
    made.profile = name;
    made.from_text = seed % 2 == 0;
    if (!made.from_text) {
        RandomGraphOptions options = all_features();
        options.max_passes = max_passes;
        options.tables = true;
        made.plan = plan_for(random_graph(seed, options), profile, queues);
        return made;
    }
    const RandomText text = random_text(seed, profile);
    const Result<ResolvedGraph> graph = resolve_text(text.text, text.params, profile);
    if (graph)
        made.plan = plan_for(*graph, profile, queues);
    else
        ADD_FAILURE() << "seed " << seed << " for " << name << " is rejected\n"
                      << to_text(graph.errors()) << text.text;
    made.omitted = text.omitted;
    return made;
}

}  // namespace weft::test

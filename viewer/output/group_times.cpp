#include "viewer/output/group_times.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace weft::viewer {
namespace {

// Returns the number of the rest unit of each pass, by the name of the pass. Passes that run in every frame
// have no rest unit, and are left out.
std::map<std::string, uint32_t> units_of_passes(const ResolvedGraph& graph) {
    std::map<std::string, uint32_t> units;
    for (const PassDecl& pass : graph.passes)
        if (pass.rest_unit != kNoId) units.emplace(pass.name, pass.rest_unit);
    return units;
}

}  // namespace

uint64_t GroupTimes::all_ran() const {
    return std::accumulate(ran.begin(), ran.end(), uint64_t{0});
}

double GroupTimes::all_gpu_ms() const {
    if (std::ranges::any_of(gpu_ms, [](double ms) { return ms < 0; })) return -1;
    return std::accumulate(gpu_ms.begin(), gpu_ms.end(), 0.0);
}

std::string name_without_round(const std::string& pass) {
    return pass.substr(0, pass.find('#'));
}

std::vector<GroupTimes> group_times(const FramePlan& plan, std::span<const vk::FrameTiming> timings) {
    const std::vector<GroupDecl>& groups = plan.graph.groups;
    std::vector<GroupTimes> all;
    for (const GroupDecl& group : groups) all.push_back({group.name, group.rounds, {}, {}, {}});
    if (groups.empty()) return all;
    const std::map<std::string, uint32_t> units = units_of_passes(plan.graph);
    for (const vk::FrameTiming& frame : timings) {
        std::vector<double> ms(groups.size(), 0);
        std::vector<std::set<uint32_t>> ran(groups.size());
        for (const vk::PassTiming& pass : frame.passes) {
            const auto unit = units.find(pass.pass);
            if (unit == units.end() || pass.rested || pass.switched_off) continue;
            const auto group = std::ranges::find_if(
                groups, [&](const GroupDecl& each) { return each.has_unit(unit->second); });
            if (group == groups.end()) continue;
            const auto i = static_cast<size_t>(group - groups.begin());
            ran[i].insert(unit->second);
            const auto add = [&](double& sum) { sum = sum < 0 || pass.gpu_ms < 0 ? -1 : sum + pass.gpu_ms; };
            add(ms[i]);
            add(all[i].pass_ms[name_without_round(pass.pass)]);
        }
        for (size_t i = 0; i < groups.size(); ++i) {
            all[i].ran.push_back(static_cast<uint32_t>(ran[i].size()));
            all[i].gpu_ms.push_back(ms[i]);
        }
    }
    return all;
}

}  // namespace weft::viewer

#include "vulkan/execute/pass_lists.h"

#include <algorithm>
#include <vector>

namespace weft::vk {
namespace {

// Graphs with light probes have thousands of passes, so a list ends after this number of entries.
constexpr size_t kMostListed = 24;

// Returns the first entries with commas between them, and the number of the others.
std::string list_text(const std::vector<std::string>& first, size_t all) {
    std::string text;
    for (const std::string& entry : first) text += (text.empty() ? "" : ", ") + entry;
    if (all > first.size()) text += " and " + std::to_string(all - first.size()) + " more";
    return text;
}

}  // namespace

std::string pass_names(const FramePlan& plan, uint32_t first) {
    const size_t all = plan.schedule.order.size() - first;
    std::vector<std::string> names;
    for (size_t i = 0; i < std::min(all, kMostListed); ++i)
        names.push_back(plan.graph.passes[plan.schedule.order[first + i]].name);
    return list_text(names, all);
}

std::string draw_counts(const FramePlan& plan, const DrawSource* draws, uint32_t first) {
    std::vector<std::string> counts;
    size_t all = 0;
    for (size_t position = first; draws != nullptr && position < plan.schedule.order.size(); ++position) {
        const PassDecl& pass = plan.graph.passes[plan.schedule.order[position]];
        uint64_t count = 0;
        for (const std::string& list : pass.draw_lists) count += draws->draw_count(list);
        if (count == 0) continue;
        ++all;
        if (all <= kMostListed) counts.push_back(pass.name + " " + std::to_string(count));
    }
    return list_text(counts, all);
}

}  // namespace weft::vk

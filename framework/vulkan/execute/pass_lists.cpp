#include "vulkan/execute/pass_lists.h"

#include <algorithm>
#include <vector>

namespace weft::vk {
namespace {

// Returns the names with commas between them. Graphs with light probes have thousands of passes, so the list
// ends after kMostListed names.
std::string list_text(const std::vector<std::string>& names) {
    constexpr size_t kMostListed = 24;
    std::string text;
    for (size_t i = 0; i < std::min(names.size(), kMostListed); ++i)
        text += (text.empty() ? "" : ", ") + names[i];
    if (names.size() > kMostListed) text += " and " + std::to_string(names.size() - kMostListed) + " more";
    return text;
}

}  // namespace

std::string pass_names(const FramePlan& plan, uint32_t first) {
    std::vector<std::string> names;
    for (size_t position = first; position < plan.schedule.order.size(); ++position)
        names.push_back(plan.graph.passes[plan.schedule.order[position]].name);
    return list_text(names);
}

std::string draw_counts(const FramePlan& plan, const DrawSource* draws, uint32_t first) {
    std::vector<std::string> counts;
    for (size_t position = first; draws != nullptr && position < plan.schedule.order.size(); ++position) {
        const PassDecl& pass = plan.graph.passes[plan.schedule.order[position]];
        uint64_t count = 0;
        for (const std::string& list : pass.draw_lists) count += draws->draw_count(list);
        if (count > 0) counts.push_back(pass.name + " " + std::to_string(count));
    }
    return list_text(counts);
}

}  // namespace weft::vk

#include "graph/rest/needed_by_units.h"

namespace weft {
namespace {

// For each position, the position of the first pass of its rendering scope.
std::vector<uint32_t> first_of_scopes(const FramePlan& plan) {
    const auto count = static_cast<uint32_t>(plan.schedule.order.size());
    std::vector<uint32_t> first(count);
    std::vector<uint32_t> last_on_queue(plan.schedule.queues.size(), kNoId);
    for (uint32_t position = 0; position < count; ++position) {
        uint32_t& last = last_on_queue[plan.schedule.queue[Position(position)]];
        const bool merges = plan.barriers.steps[Position(position)].merges_render_pass && last != kNoId;
        first[position] = merges ? first[last] : position;
        last = position;
    }
    return first;
}

}  // namespace

std::vector<uint8_t> needed_by_units(const FramePlan& plan) {
    const auto count = static_cast<uint32_t>(plan.schedule.order.size());
    std::vector<std::vector<uint32_t>> sources(count), scopes(count);
    for (const EdgeDecl& edge : plan.graph.edges) {
        const bool uses_content = edge.kind == EdgeKind::raw || edge.kind == EdgeKind::waw;
        const Position from = plan.schedule.position[edge.from], to = plan.schedule.position[edge.to];
        if (uses_content && from != kNoId && to != kNoId) sources[to].push_back(from);
    }
    const std::vector<uint32_t> first = first_of_scopes(plan);
    for (uint32_t position = 0; position < count; ++position) scopes[first[position]].push_back(position);
    std::vector<uint8_t> needed(count, 0);
    std::vector<uint32_t> open;
    const auto need = [&](uint32_t position) {
        if (needed[position] == 0) open.push_back(position);
        needed[position] = 1;
    };
    for (uint32_t position = 0; position < count; ++position)
        if (plan.graph.passes[plan.schedule.order[Position(position)]].rest_unit != kNoId) need(position);
    while (!open.empty()) {
        const uint32_t position = open.back();
        open.pop_back();
        for (const uint32_t source : sources[position]) need(source);
        for (const uint32_t neighbour : scopes[first[position]]) need(neighbour);
    }
    return needed;
}

}  // namespace weft

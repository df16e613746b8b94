// Purpose: makes the inputs of single compile stages by hand, so that a test of one stage calls no other
// stage.
#pragma once

#include <string>
#include <vector>

#include "weft/declaration.h"
#include "weft/plan.h"

namespace weft::test {

inline PassId pass_of(const ResolvedGraph& graph, const std::string& name) {
    return find_pass(graph, name);
}

inline ResourceId resource_of(const ResolvedGraph& graph, const std::string& name) {
    return find_resource(graph, name);
}

inline LiveGraph all_live(const ResolvedGraph& graph) {
    LiveGraph live;
    live.live_passes.assign(graph.passes.size(), 1);
    live.live_resources.assign(graph.resources.size(), 1);
    live.reasons.assign(graph.passes.size(), CullReason::live);
    live.details.resize(graph.passes.size());
    return live;
}

// Returns a graphics queue and a compute queue, both of queue family 0.
inline std::vector<LogicalQueue> two_queues() {
    return {{QueueKind::graphics, 0}, {QueueKind::compute, 0}};
}

// Returns a schedule that runs the passes in the given order. `queue[i]` is the queue of the i-th pass;
// without `queue`, all passes run on queue 0. The schedule has no vector clocks.
inline Schedule in_order(const ResolvedGraph& graph, const std::vector<std::string>& passes,
                         std::vector<QueueIndex> queue = {}) {
    Schedule order;
    order.position.assign(graph.passes.size(), kNoId);
    for (const std::string& name : passes) {
        order.position[pass_of(graph, name)] = Position(order.order.size());
        order.order.push_back(pass_of(graph, name));
    }
    if (!queue.empty()) order.queues = two_queues();
    if (queue.empty()) queue.assign(passes.size(), 0);
    order.queue = std::move(queue);
    return order;
}

}  // namespace weft::test

// Purpose: assigns a logical queue to every pass of a schedule.
#pragma once

#include <vector>

#include "weft/plan.h"

namespace weft {

// Returns the queue of each pass, indexed by the pass's position in `order`. `queues[0]` must be a graphics
// queue, because it gets every pass that no other queue can run.
[[nodiscard]] std::vector<QueueIndex> assign_queues(const ResolvedGraph& graph,
                                                    const std::vector<PassId>& order,
                                                    const std::vector<LogicalQueue>& queues);

}  // namespace weft

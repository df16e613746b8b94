// Purpose: one logical queue for every pass of an order.
#pragma once

#include <vector>

#include "weft/plan.h"

namespace weft {

// By position. `queues[0]` can do everything.
[[nodiscard]] std::vector<QueueIndex> assign_queues(const ResolvedGraph& graph,
                                                    const std::vector<PassId>& order,
                                                    const std::vector<LogicalQueue>& queues);

}  // namespace weft

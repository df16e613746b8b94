// Purpose: moves the passes of each group together. Private to schedule().
#pragma once

#include <vector>

#include "graph/schedule/schedule_candidates.h"

namespace weft {

// Returns the order with the passes of each group one after another, round by round. All other passes keep
// their order as far as the edges of the graph allow it. resolve() has checked that such an order exists.
[[nodiscard]] std::vector<PassId> gather_groups(const ResolvedGraph& graph, const ScheduleProblem& problem,
                                                const std::vector<PassId>& order);

}  // namespace weft

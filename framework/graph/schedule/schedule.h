// Purpose: an order for the live passes, and a queue for each.
#pragma once

#include <vector>

#include "weft/compile.h"
#include "weft/declaration.h"
#include "weft/plan.h"

namespace weft {

// `needs` weighs the memory that each candidate order takes. The edges have no cycle: resolve() reports those
// (W150).
[[nodiscard]] Schedule schedule(const ResolvedGraph& graph, const LiveGraph& live, const MemoryNeeds& needs,
                                const std::vector<LogicalQueue>& queues = {LogicalQueue{}});

}  // namespace weft

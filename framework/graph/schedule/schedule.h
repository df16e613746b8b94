// Purpose: chooses the order in which the live passes run, and a queue for each pass.
#pragma once

#include <vector>

#include "weft/compile.h"
#include "weft/declaration.h"
#include "weft/plan.h"

namespace weft {

// `needs` gives the size of each resource, from which the memory of each candidate order is computed. The
// edges of the graph must have no cycle; resolve() has already reported cycles as error W150.
[[nodiscard]] Schedule schedule(const ResolvedGraph& graph, const LiveGraph& live, const MemoryNeeds& needs,
                                const std::vector<LogicalQueue>& queues = {LogicalQueue{}});

}  // namespace weft

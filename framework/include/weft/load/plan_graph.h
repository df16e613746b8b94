// Purpose: compiles a graph file to a plan without a device. A device profile replaces the device. Errors:
// those of load_graph().
#pragma once

#include <cstdint>

#include "weft/load/load_graph.h"
#include "weft/plan.h"
#include "weft/result.h"

namespace weft {

struct PlannedGraph {
    LoadedGraph loaded;
    FramePlan plan;  // The plan is not checked yet: call check_plan() (weft/check/check_plan.h).
};

// Makes the plan for the tier of the request, for a device with `queue_count` logical queues. Warnings are
// added to `warnings`.
[[nodiscard]] Result<PlannedGraph> plan_graph(const JsonDoc& document, const LoadInput& input,
                                              uint32_t queue_count, Diagnostics& warnings);

}  // namespace weft

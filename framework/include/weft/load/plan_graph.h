// Purpose: the complete compiler, from a graph file to a plan, without a device: a device profile replaces
// the device. Errors: those of load_graph().
#pragma once

#include <cstdint>

#include "weft/load/load_graph.h"
#include "weft/plan.h"
#include "weft/result.h"

namespace weft {

struct PlannedGraph {
    LoadedGraph loaded;
    FramePlan plan;  // not checked yet: call check_plan() (weft/check/check_plan.h)
};

// Makes the plan of the request's tier for a device with `queue_count` logical queues. Adds warnings to
// `warnings`.
[[nodiscard]] Result<PlannedGraph> plan_graph(const JsonDoc& document, const LoadInput& input,
                                              uint32_t queue_count, Diagnostics& warnings);

}  // namespace weft

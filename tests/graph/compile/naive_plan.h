// Purpose: a trivially correct plan for comparison with the compiler's plan: all passes in topological order,
// no culling, separate memory for every resource, and before each pass a barrier from all stages to all
// stages. It is built from the graph alone and shares no code with the compiler's stages.
#pragma once

#include "weft/plan.h"

namespace weft::test {

// `needs` is indexed by ResourceId and comes from the device that runs the plan.
[[nodiscard]] FramePlan naive_plan(const ResolvedGraph& graph, const MemoryNeeds& needs);
// Computes memory sizes from the contents alone.
[[nodiscard]] FramePlan naive_plan(const ResolvedGraph& graph);

}  // namespace weft::test

// Purpose: the plan nobody can get wrong, to compare the compiler's with: every pass in topological order,
// nothing culled, every resource in memory of its own, and before each pass a barrier from everything to
// everything. It is built from the graph alone and shares no code with the compiler's stages.
#pragma once

#include "weft/plan.h"

namespace weft::test {

// `needs` by ResourceId, from the device that will run the plan.
[[nodiscard]] FramePlan naive_plan(const ResolvedGraph& graph, const MemoryNeeds& needs);
// With sizes from the contents alone.
[[nodiscard]] FramePlan naive_plan(const ResolvedGraph& graph);

}  // namespace weft::test

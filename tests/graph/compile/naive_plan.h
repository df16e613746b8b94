// Purpose: makes a trivially correct plan, so that tests can compare the compiler's plan with it. The plan
// runs all passes in topological order and culls none. Every resource has separate memory. Before each pass,
// every resource that the pass uses has a barrier from all device stages to all device stages. The code
// shares nothing with the stages of the compiler.
#pragma once

#include "weft/plan.h"

namespace weft::test {

// Makes a naive plan with the memory requirements of the device that runs the plan. `needs` is indexed by
// ResourceId.
[[nodiscard]] FramePlan naive_plan(const ResolvedGraph& graph, const MemoryNeeds& needs);
// Makes a naive plan without a device: a resource needs as many bytes of memory as its content has.
[[nodiscard]] FramePlan naive_plan(const ResolvedGraph& graph);

}  // namespace weft::test

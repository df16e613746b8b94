// Purpose: checks a plan independently of the compiler. The checker derives the happens-before order from the
// declared accesses and the plan alone. With this order it checks all reads, writes, layouts, lifetimes and
// reuses of memory in at least three consecutive frames. It shares no code with the stages of the compiler;
// its only input is the plan with its declarations. Errors: C3xx. An error about the order of two passes
// names both passes and the resource.
#pragma once

#include "weft/plan.h"
#include "weft/result.h"

namespace weft {

// Returns the errors of the plan; empty if there is none.
[[nodiscard]] Diagnostics check_plan(const FramePlan& plan);

}  // namespace weft

// Purpose: checks a plan. It reconstructs the happens-before order from the declared accesses and the plan
// alone, and checks every read, write, layout, memory reuse and lifetime over three consecutive frames. It
// shares no code with the compiler's stages, and includes only declarations and plans. Errors: C3xx, each
// naming both passes and the resource.
#pragma once

#include "weft/plan.h"
#include "weft/result.h"

namespace weft {

// Empty if the plan is sound.
[[nodiscard]] Diagnostics check_plan(const FramePlan& plan);

}  // namespace weft

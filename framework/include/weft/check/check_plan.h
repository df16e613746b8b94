// Purpose: proves a plan. From the declared accesses and the plan alone it rebuilds what happens before what,
// and checks every read, write, layout, hand-over and lifetime over three consecutive frames. It shares no
// code with the stages it judges, and includes only declarations and plans. Errors: C3xx, each naming both
// passes and the resource.
#pragma once

#include "weft/plan.h"
#include "weft/result.h"

namespace weft {

// Empty: the plan is sound.
[[nodiscard]] Diagnostics check_plan(const FramePlan& plan);

}  // namespace weft

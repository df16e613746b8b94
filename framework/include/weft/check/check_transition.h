// Purpose: checks the transition from one plan to the next. Every copy of every persistent resource of the
// new plan must get its content exactly once: from the resource of the same name in the old plan, or as its
// first-frame value. Order and layouts must be right. Errors: C370 wrong content, C371 wrong synchronisation
// or layout.
#pragma once

#include "weft/result.h"
#include "weft/transition.h"

namespace weft {

[[nodiscard]] Diagnostics check_transition(const FramePlan& old_plan, const FramePlan& new_plan,
                                           const TransitionPlan& transition);

}  // namespace weft

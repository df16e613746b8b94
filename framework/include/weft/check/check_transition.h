// Purpose: checks a transition between two plans: every copy of every persistent resource of the new plan
// gets its content exactly once, from the resource of the same name or as its first-frame value, in the right
// order and layouts. Errors: C370 content, C371 synchronisation and layouts.
#pragma once

#include "weft/result.h"
#include "weft/transition.h"

namespace weft {

[[nodiscard]] Diagnostics check_transition(const FramePlan& old_plan, const FramePlan& new_plan,
                                           const TransitionPlan& transition);

}  // namespace weft

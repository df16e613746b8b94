// Purpose: what can be judged without playing the plan: that every live pass is there once and in order, that
// lifetimes cover all uses, that placements lie inside their heaps, that hand-overs and barriers speak of the
// same things.
#pragma once

#include "check/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

// False when the plan is too broken to be played.
[[nodiscard]] bool check_structure(const FramePlan& plan, FaultList& faults);

}  // namespace weft::check

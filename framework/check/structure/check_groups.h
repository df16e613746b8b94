// Purpose: checks the groups of a plan. A frame may run the rounds of a group in any order and leave some of
// them out. So the passes of a group must stand together in one batch, and everything that they share (waits,
// and barriers that are recorded in every frame) must come before or after all of them. check_rest_units()
// checks that each round begins and ends in the same states.
#pragma once

#include "check/faults/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

// Errors: C335.
void check_groups(const FramePlan& plan, FaultList& faults);

}  // namespace weft::check

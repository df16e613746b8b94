// Purpose: checks the groups of a plan. A group is a set of passes; each round of the group is one copy of
// all these passes. A frame may run the rounds in any order and leave some of them out. So the passes of a
// group must stand together in one batch. Everything that the rounds share (waits, and barriers that are
// recorded in every frame) must come before or after all passes of the group. check_rest_units() checks that
// each round begins and ends in the same states.
#pragma once

#include "check/faults/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

// Errors: C335.
void check_groups(const FramePlan& plan, FaultList& faults);

}  // namespace weft::check

// Purpose: checks a plan without a replay (the simulation of frames): every live pass occurs once and in
// order, lifetimes cover all uses, placements lie inside their heaps, and the barriers match the memory plan
// and the submissions.
#pragma once

#include "check/faults/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

// Returns false if the plan has errors that make a replay impossible.
[[nodiscard]] bool check_structure(const FramePlan& plan, FaultList& faults);

}  // namespace weft::check

// Purpose: checks that need no replay: every live pass occurs once and in order, lifetimes cover all uses,
// placements lie inside their heaps, alias barriers and other barriers are consistent.
#pragma once

#include "check/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

// Returns false when the plan is too broken for a replay.
[[nodiscard]] bool check_structure(const FramePlan& plan, FaultList& faults);

}  // namespace weft::check

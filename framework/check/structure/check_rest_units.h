// Purpose: checks the passes that rest, which means that they do not run in every frame. The passes of a rest
// unit run together, in any frames. The replay runs all units in every frame; this file checks that the plan
// is also right if only some of the units run. Outside the steps of its unit, each part that the unit writes
// stays in its home state: always the same layout, with the unit's last result as content. So a pass outside
// the unit finds the same state whether the unit rests or not. Errors: C333, a result is lost or depends on
// when the unit runs; C334, a barrier is recorded in the wrong frames, or leaves the part in another state
// than the home state.
#pragma once

#include "check/faults/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

void check_rest_units(const FramePlan& plan, FaultList& faults);

}  // namespace weft::check

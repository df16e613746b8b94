// Purpose: checks the passes that rest. The passes of a rest unit run together, in any frames. The replay
// runs all units in every frame; this file checks that any other choice of units is right, too. Outside the
// steps of its unit, each part that the unit writes stays in its home state: always the same layout, with the
// unit's last result as content. So a pass outside the unit cannot tell whether the unit rests. Errors: C333
// a result is lost or depends on when the unit runs, C334 a barrier is recorded in the wrong frames or leaves
// the home state.
#pragma once

#include "check/faults/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

void check_rest_units(const FramePlan& plan, FaultList& faults);

}  // namespace weft::check

// Purpose: checks reads of passes that take turns (`perFrame`): in a frame any set of turns may run, and each
// read must still see the version that its declaration names. Culled passes count as writers: a plan must not
// omit a pass because another one overwrites its result, if the other one runs in different frames. Errors:
// C331 content that is discarded, C332.
#pragma once

#include "check/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

void check_turns(const FramePlan& plan, FaultList& faults);

}  // namespace weft::check

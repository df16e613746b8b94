// Purpose: whether passes that take turns leave what others read: in a frame any set of turns may run, and
// still each read must see the version that its declaration names. Culled passes count as writers: a plan may
// not leave out a pass because another one overwrites its work, if the other one runs in other frames.
// Errors: C331 content that is dropped, C332.
#pragma once

#include "check/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

void check_turns(const FramePlan& plan, FaultList& faults);

}  // namespace weft::check

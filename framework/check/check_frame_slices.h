// Purpose: checks the reads of passes that run only in some frames, because a repeat with `perFrame` divides
// its passes into frame slices. In a frame any set of slices may run, and each read must still see the
// version that its declaration names. Culled passes count as writers: the compiler must not cull a pass
// because another pass overwrites its result, if the other pass runs in different frames. Errors: C331
// content that is discarded, C332.
#pragma once

#include "check/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

void check_frame_slices(const FramePlan& plan, FaultList& faults);

}  // namespace weft::check

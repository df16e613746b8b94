// Purpose: checks the buffers from which the GPU reads numbers of workgroups, draw commands and numbers of
// draws: the GPU must not read beyond the bytes for which the plan has barriers.
#pragma once

#include "check/faults/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

// Errors: C345.
void check_indirect(const FramePlan& plan, FaultList& faults);

}  // namespace weft::check

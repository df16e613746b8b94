// Purpose: checks the pieces of buffers. The plan tracks the pieces of a buffer like the layers of an image.
// So the pieces of each use must contain exactly the bytes that its port names.
#pragma once

#include "check/faults/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

// Errors: C344.
void check_pieces(const FramePlan& plan, FaultList& faults);

}  // namespace weft::check

// Purpose: checks passes that read their view (the matrices of a camera) from a buffer. Such a pass must read
// the right element of the buffer. Errors: C347.
#pragma once

#include "check/faults/fault_list.h"

namespace weft::check {

void check_buffer_views(const FramePlan& plan, FaultList& faults);

}  // namespace weft::check

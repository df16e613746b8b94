// Purpose: checks that passes whose view is in a buffer read the right element of this buffer. Errors: C347.
#pragma once

#include "check/faults/fault_list.h"

namespace weft::check {

void check_buffer_views(const FramePlan& plan, FaultList& faults);

}  // namespace weft::check

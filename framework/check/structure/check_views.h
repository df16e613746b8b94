// Purpose: checks the passes that draw several views: their views, and the layers to which these are drawn.
// Errors: C346.
#pragma once

#include "check/faults/fault_list.h"

namespace weft::check {

void check_views(const FramePlan& plan, FaultList& faults);

}  // namespace weft::check

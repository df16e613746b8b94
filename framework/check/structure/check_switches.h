// Purpose: checks that passes with switches and their variants are declared consistently: each pass runs in
// the combinations of its switch, and each port has one resource, or none, in each combination. Errors: C349.
#pragma once

#include "check/faults/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

void check_switches(const FramePlan& plan, FaultList& faults);

}  // namespace weft::check

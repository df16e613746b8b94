// Purpose: checks the tables of textures: passes only sample them, and the plan has no barrier for them,
// because their textures are always in the layout in which shaders sample them.
#pragma once

#include "check/faults/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

// Errors: C348.
void check_tables(const FramePlan& plan, FaultList& faults);

}  // namespace weft::check

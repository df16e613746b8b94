// Purpose: checks the tables of textures, which are lists of textures that shaders index. Passes must only
// sample a table. The plan must have no barrier for a table, because its textures are always in the layout in
// which shaders sample them.
#pragma once

#include "check/faults/fault_list.h"
#include "weft/plan.h"

namespace weft::check {

// Errors: C348.
void check_tables(const FramePlan& plan, FaultList& faults);

}  // namespace weft::check

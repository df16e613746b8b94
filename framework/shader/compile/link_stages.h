// Purpose: gives the stages of one program matching binding numbers and locations. Resources of set 1 are
// numbered by name over all stages, and used resources come first. Inputs and outputs without a location are
// matched by name. After this, every input of the fragment stage must have an output of the vertex stage with
// the same location and type. Only numbers inside the SPIR-V change. Fault: W205.
#pragma once

#include <vector>

#include "shader/compile/glsl_compile.h"
#include "shader/faults/interface_fault.h"

namespace weft::shader {

void link_stages(std::vector<CompiledStage>& stages, InterfaceFaults& faults);

}  // namespace weft::shader

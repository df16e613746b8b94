// Purpose: the stages of one program get numbers that agree. Resources of set 1 are numbered by name over all
// stages, the used ones first; inputs and outputs without a location are joined by name; then every input
// must find an output of its type. Only numbers inside the SPIR-V change. Errors: W205, as faults.
#pragma once

#include <vector>

#include "shader/compile/glsl_compile.h"
#include "shader/faults/interface_fault.h"

namespace weft::shader {

void link_stages(std::vector<CompiledStage>& stages, InterfaceFaults& faults);

}  // namespace weft::shader

// Purpose: computes the interface of a program from the final SPIR-V of its stages. Declarations that no
// stage uses are left out. Fault W205: declarations conflict, for example if two stages declare the same name
// differently, or if two resources have the same binding. Fault W206: no pass can provide the interface.
#pragma once

#include <vector>

#include "shader/faults/interface_fault.h"
#include "weft/shader_interface.h"

namespace weft::shader {

[[nodiscard]] ShaderInterface reflect_program(const std::vector<ShaderModule>& modules,
                                              InterfaceFaults& faults);

}  // namespace weft::shader

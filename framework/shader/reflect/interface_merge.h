// Purpose: the interface of a program, from the final SPIR-V of its stages. What no stage uses is left out.
// Errors: W205 stages that declare one thing in two ways, W206 an interface no pass can offer; as faults.
#pragma once

#include <vector>

#include "shader/faults/interface_fault.h"
#include "weft/shader_interface.h"

namespace weft::shader {

[[nodiscard]] ShaderInterface reflect_program(const std::vector<ShaderModule>& modules,
                                              InterfaceFaults& faults);

}  // namespace weft::shader

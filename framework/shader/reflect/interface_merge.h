// Purpose: computes the interface of a program from the final SPIR-V of its stages. Unused declarations are
// omitted. Faults: W205 stages that declare the same name differently, W206 an interface that no pass can
// offer.
#pragma once

#include <vector>

#include "shader/faults/interface_fault.h"
#include "weft/shader_interface.h"

namespace weft::shader {

[[nodiscard]] ShaderInterface reflect_program(const std::vector<ShaderModule>& modules,
                                              InterfaceFaults& faults);

}  // namespace weft::shader

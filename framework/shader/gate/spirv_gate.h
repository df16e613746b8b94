// Purpose: decides which SPIR-V modules are allowed. Capabilities, extensions and instruction sets must be in
// a list of allowed ones, and the device must support them. The memory of the module's own variables is
// limited. The gate accepts any input without crashing. The module must also pass spirv-val, which checks
// that the module declares the capability of each instruction. Units: bytes, words. Error W208: a capability,
// an extension, an instruction set or an initial value of a shared variable is not allowed. Error W209: the
// variables or the inlined code are too large, or types or calls are nested too deeply.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shader/faults/interface_fault.h"
#include "weft/limits.h"
#include "weft/shader/shader_target.h"

namespace weft::shader {

struct GateRules {
    ShaderTarget target;
    ShaderLimits limits;
};

// Returns the reasons why the module is rejected. The list is empty if the module is allowed.
[[nodiscard]] InterfaceFaults gate_faults(ShaderStage stage, std::span<const uint32_t> spirv,
                                          const GateRules& rules);

// gate_faults() consists of these two checks. The first one reports W208, the second one W209.
void capability_faults(ShaderStage stage, std::span<const uint32_t> spirv, const GateRules& rules,
                       InterfaceFaults& faults);
void storage_faults(ShaderStage stage, std::span<const uint32_t> spirv, const GateRules& rules,
                    InterfaceFaults& faults);

}  // namespace weft::shader

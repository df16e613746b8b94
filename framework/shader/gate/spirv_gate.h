// Purpose: decides which SPIR-V modules are allowed: an allow-list of capabilities, extensions and
// instruction sets, limited to those that the device supports, and limits on the memory of a module's own
// variables. It is safe for any input. spirv-val must accept the module too: it proves that the capability of
// each instruction is declared. Units: bytes, words. Errors: W208 a capability, extension or use that is not
// allowed, W209 more storage or depth than allowed.
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

// Empty when the module is allowed.
[[nodiscard]] InterfaceFaults gate_faults(ShaderStage stage, std::span<const uint32_t> spirv,
                                          const GateRules& rules);

// The parts of gate_faults().
void capability_faults(ShaderStage stage, std::span<const uint32_t> spirv, const GateRules& rules,
                       InterfaceFaults& faults);
void storage_faults(ShaderStage stage, std::span<const uint32_t> spirv, const GateRules& rules,
                    InterfaceFaults& faults);

}  // namespace weft::shader

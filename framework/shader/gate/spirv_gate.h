// Purpose: what a SPIR-V module may ask for. An allow-list of capabilities, extensions and instruction
// sets, joined with what the device offers, and caps on the memory that a module's own variables take. It
// reads any words without harm. spirv-val must pass as well: it proves that the capability of each
// instruction is declared. Units: bytes, words. Errors: W208 a capability, extension or use that is not
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

// Nothing: the module may go on.
[[nodiscard]] InterfaceFaults gate_faults(ShaderStage stage, std::span<const uint32_t> spirv,
                                          const GateRules& rules);

// The parts of gate_faults().
void capability_faults(ShaderStage stage, std::span<const uint32_t> spirv, const GateRules& rules,
                       InterfaceFaults& faults);
void storage_faults(ShaderStage stage, std::span<const uint32_t> spirv, const GateRules& rules,
                    InterfaceFaults& faults);

}  // namespace weft::shader

// Purpose: the SPIR-V capabilities that glslang 12 can emit, and which of them a shader may use. The gate
// uses this one table, and docs/shaders.md shows it. A capability that is not in the table is rejected.
#pragma once

#include <cstdint>
#include <span>

#include "weft/device_profile.h"

namespace weft::shader {

enum class CapabilityRule : uint8_t {
    always,   // enabled on every device that Weft creates
    device,   // allowed if the device supports the feature `needs`
    compute,  // allowed in compute stages; if `needs` is not 0, only if the device supports it
    never,    // never enabled on a device
};

struct CapabilityRow {
    uint32_t capability = 0;
    const char* name = "";
    CapabilityRule rule = CapabilityRule::never;
    ShaderCapabilityMask needs = 0;
    // GLSL words that lead to this capability, separated by spaces, to find the error's place; "dmat*" is a
    // prefix.
    const char* words = "";
    const char* remedy = "";
};

[[nodiscard]] std::span<const CapabilityRow> capability_table();
// Null when the capability is not in the table.
[[nodiscard]] const CapabilityRow* find_capability(uint32_t capability);

}  // namespace weft::shader

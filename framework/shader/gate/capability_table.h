// Purpose: the capabilities of SPIR-V that glslang 12 can emit, and which of them a shader may use. One
// table: the gate judges by it, and docs/shaders.md shows it. A capability that is not in it is refused.
#pragma once

#include <cstdint>
#include <span>

#include "weft/device_profile.h"

namespace weft::shader {

enum class CapabilityRule : uint8_t {
    always,   // each device that Weft runs on is made with it
    device,   // if the device offers it: `needs`
    compute,  // in compute stages, if the device offers it: `needs`, where that is not 0
    never,    // no device is made with it
};

struct CapabilityRow {
    uint32_t capability = 0;
    const char* name = "";
    CapabilityRule rule = CapabilityRule::never;
    ShaderCapabilityMask needs = 0;
    // What asks for it in GLSL, for the error's place: whole words separated by spaces; "dmat*" is a
    // beginning.
    const char* words = "";
    const char* remedy = "";
};

[[nodiscard]] std::span<const CapabilityRow> capability_table();
// Null: not in the table.
[[nodiscard]] const CapabilityRow* find_capability(uint32_t capability);

}  // namespace weft::shader

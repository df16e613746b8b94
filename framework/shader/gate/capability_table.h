// Purpose: lists the SPIR-V capabilities that glslang 12 can produce, and says which of them a shader may
// use. The SPIR-V gate uses only this table, and docs/shaders.md shows it. A capability that is not in the
// table is rejected.
#pragma once

#include <cstdint>
#include <span>

#include "weft/device_profile.h"

namespace weft::shader {

enum class CapabilityRule : uint8_t {
    always,  // The capability is allowed, because every device that Weft can use supports it.
    // The capability is allowed if the device supports the feature `needs`. Exception: for
    // StorageImageReadWithoutFormat, ShaderTarget::storage_read_without_format decides.
    device,
    // The capability is allowed only in compute stages. If `needs` is not 0, the device must support this
    // feature.
    compute,
    // The gate allows the capability. Reflection records it as ShaderInterface::needs_texture_tables, and
    // resolve() reports W231 for a pass with such a shader if the device has no tables of textures.
    tables,
    never,  // The capability is rejected, because Weft never enables it.
};

struct CapabilityRow {
    uint32_t capability = 0;
    const char* name = "";
    CapabilityRule rule = CapabilityRule::never;
    ShaderCapabilityMask needs = 0;
    // GLSL words that lead to this capability, separated by spaces. They help to find the line of the error.
    // A word that ends in "*", such as "dmat*", is a prefix.
    const char* words = "";
    const char* remedy = "";
};

[[nodiscard]] std::span<const CapabilityRow> capability_table();
// Returns the row of a capability, or null if the capability is not in the table.
[[nodiscard]] const CapabilityRow* find_capability(uint32_t capability);

}  // namespace weft::shader

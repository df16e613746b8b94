// Purpose: the properties of a device that determine which SPIR-V is allowed. By default all optional
// properties are supported, so that shaders can be compiled without a device.
#pragma once

#include <cstdint>

#include "weft/device_profile.h"

namespace weft {

struct ShaderTarget {
    ShaderCapabilityMask capabilities = ~ShaderCapabilityMask{0};
    bool storage_read_without_format = true;
    uint64_t max_shared_bytes = UINT64_MAX;
    // True: arrays of sampled images may have any index.
    bool texture_tables = true;
    bool operator==(const ShaderTarget&) const = default;
};

[[nodiscard]] inline ShaderTarget shader_target(const DeviceProfile& profile) {
    return {profile.shader_capabilities, profile.storage_read_without_format, profile.max_shared_bytes,
            profile.texture_table > 0};
}

}  // namespace weft

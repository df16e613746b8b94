// Purpose: rewrites shaders so that the driver cannot treat uniform values as compile-time constants.
//
// llvmpipe compiles the uniforms that branches and loops depend on into the machine code as constants, and
// compiles the shader again when such a value changes. A frame index changes in every frame. Mesa 22.3 also
// compiles again when a buffer is only bound again, and never frees the code, so memory grows until the
// process ends. This affects uniform blocks with a constant descriptor index, and push constants. So on
// llvmpipe every block becomes an array of one block, indexed by a push constant that is always 0, and push
// constants become a uniform block. The bound buffers do not change. Other drivers get the original shaders.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "weft/vulkan/executor.h"

namespace weft::vk {

// The binding that replaces a shader's push constants.
struct BlockPlace {
    uint32_t set = 0;
    uint32_t binding = 0;
};

// True if `spirv`, which must have passed spirv-val, accesses its blocks only member by member. This holds
// for all modules compiled from GLSL.
[[nodiscard]] bool can_hide_uniforms(std::span<const uint32_t> spirv);
// The same module with hidden uniforms; the result passes spirv-val too. Requires can_hide_uniforms().
// Modules without uniforms are returned unchanged.
[[nodiscard]] std::vector<uint32_t> with_opaque_uniforms(std::span<const uint32_t> spirv,
                                                         const BlockPlace& push_constants);

// Rewrites all modules and the interface. Push constants get the first free binding of set 1.
[[nodiscard]] ShaderProgram with_opaque_uniforms(ShaderProgram program);

// The shaders of a plan in the form that `device` needs: the given ones, or `changed`, which this function
// fills.
[[nodiscard]] const ShaderCatalog* shaders_for(const Device& device, const ExecutorInput& input,
                                               ShaderCatalog& changed);

}  // namespace weft::vk

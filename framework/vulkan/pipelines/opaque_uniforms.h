// Purpose: rewrites shaders so that the driver cannot treat uniform values as compile-time constants.
//
// If a branch or loop depends on a uniform value, llvmpipe compiles the value into the machine code as a
// constant. It compiles the shader again when the value changes; a frame index changes in every frame. Mesa
// 22.3 also compiles again when only a buffer is bound again. llvmpipe never frees the compiled code, so
// memory grows until the process ends. This affects push constants, and uniform blocks with a constant
// descriptor index. So on llvmpipe, push constants become a uniform block, and each uniform block becomes an
// array of one block, unless it is an array already. The index into a new array is a push constant that is
// always 0; for an old array, this push constant is added to the index. The bound buffers do not change.
// Other drivers get the original shaders.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "weft/shader_interface.h"

namespace weft::vk {

// The descriptor binding of the uniform block that replaces a shader's push constants.
struct BlockPlace {
    uint32_t set = 0;
    uint32_t binding = 0;
};

// True if the module `spirv` accesses its uniform blocks only member by member. This is so for all modules
// compiled from GLSL. `spirv` must have passed spirv-val.
[[nodiscard]] bool can_hide_uniforms(std::span<const uint32_t> spirv);
// Returns the module with its uniform values hidden from the driver. The result passes spirv-val too.
// Requires can_hide_uniforms(). A module without uniforms is returned unchanged.
[[nodiscard]] std::vector<uint32_t> with_opaque_uniforms(std::span<const uint32_t> spirv,
                                                         const BlockPlace& push_constants);

// Applies with_opaque_uniforms() to all modules of a program. Push constants become a uniform block at the
// binding after the last binding in set 1. Returns the program unchanged if can_hide_uniforms() is false for
// any of its modules.
[[nodiscard]] ShaderProgram with_opaque_uniforms(ShaderProgram program);

}  // namespace weft::vk

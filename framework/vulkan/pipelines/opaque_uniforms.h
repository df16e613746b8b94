// Purpose: shaders whose uniform values the driver cannot know when it compiles them.
//
// llvmpipe takes the uniforms that a branch or a loop depends on as constants of the machine code, and
// compiles the shader again when such a value changes. A frame index changes in every frame. Mesa 22.3 also
// compiles again when a buffer is only bound again, and never frees the code: memory grows until the process
// ends. It does so for uniform blocks at a constant place, and for push constants. So on llvmpipe every block
// becomes an array of one block, whose index is a push constant that is always 0, and push constants become a
// uniform block. Which buffers are bound, and how, stays as it was. GPU drivers get the shaders as they are.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "weft/vulkan/executor.h"

namespace weft::vk {

// Where a shader finds what were its push constants.
struct BlockPlace {
    uint32_t set = 0;
    uint32_t binding = 0;
};

// Whether `spirv`, which passed spirv-val, uses its blocks only member by member. All that GLSL can say does.
[[nodiscard]] bool can_hide_uniforms(std::span<const uint32_t> spirv);
// The same module with hidden uniforms; it passes spirv-val, too. Needs can_hide_uniforms(). Modules without
// uniforms come back as they are.
[[nodiscard]] std::vector<uint32_t> with_opaque_uniforms(std::span<const uint32_t> spirv,
                                                         const BlockPlace& push_constants);

// All modules, and the interface. Push constants get the first free binding of set 1.
[[nodiscard]] ShaderProgram with_opaque_uniforms(ShaderProgram program);

// The shaders of a plan as pipelines of `device` need them: those that were given, or `changed`, which this
// fills.
[[nodiscard]] const ShaderCatalog* shaders_for(const Device& device, const ExecutorInput& input,
                                               ShaderCatalog& changed);

}  // namespace weft::vk

// Purpose: finds the shader program of each pass of a plan, in the form that the device and the lowering of
// the pass's views need.
#pragma once

#include <string>

#include "weft/vulkan/executor.h"

namespace weft::vk {

// Returns the shaders of a plan: `changed`, which this function fills with rewritten shaders, or
// input.shaders if no shader has to change. Passes with lowered views need rewritten shaders (see
// lowered_views.h), and so do all passes on llvmpipe (see opaque_uniforms.h). program_of() finds the shader
// of a pass.
[[nodiscard]] const ShaderCatalog* shaders_for(const Device& device, const ExecutorInput& input,
                                               ShaderCatalog& changed);
// Returns the shaders of a pass in the result of shaders_for(), or null if there are none for this pass.
// `shaders` may be null.
[[nodiscard]] const ShaderProgram* program_of(const ShaderCatalog* shaders, const PassDecl& pass);

}  // namespace weft::vk

// Purpose: rewrites shaders for passes that draw several views (PassDecl::lowering), so that authors write
// the same shader for every lowering.
//
// Multiview: the block of the view in descriptor set 0, binding 1, becomes an array with the constants of all
// views, and each access to the block selects the element gl_ViewIndex. Layer output: the vertex stage writes
// gl_Layer, which is the number of the view minus the number of the pass's first view. The number of the view
// is a member of the same block.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "weft/shader_interface.h"

namespace weft::vk {

// True if the module `spirv` accesses the block of the view only member by member. This is so for all modules
// compiled from GLSL. `spirv` must have passed spirv-val, here and in the functions below.
[[nodiscard]] bool can_select_view(std::span<const uint32_t> spirv);
// Returns the module for a pass with multiview; `views` is the number of its views. The result passes
// spirv-val too. Requires can_select_view(). A module that does not read the view is returned unchanged.
[[nodiscard]] std::vector<uint32_t> with_multiview(std::span<const uint32_t> spirv, ShaderStage stage,
                                                   uint32_t views);
// Returns the vertex module `spirv` for a pass with layer output; `first` is the number of its first view.
// The result passes spirv-val too.
[[nodiscard]] std::vector<uint32_t> with_layer_output(std::span<const uint32_t> spirv, uint32_t first);

}  // namespace weft::vk

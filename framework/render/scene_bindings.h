// Purpose: the contents of descriptor sets 0 (frame), 2 (material) and 3 (draw) while a scene is drawn. One
// table serves both for creating the layouts and for checking shaders. The shaders' side:
// shaders/include/frame_set.glsl, material_set.glsl and surface_vertex.glsl.
#pragma once

#include <vector>

#include "vulkan/device/functions.h"
#include "weft/imports.h"

namespace weft::render {

[[nodiscard]] std::vector<OfferedBinding> scene_bindings();
[[nodiscard]] std::vector<VkDescriptorSetLayoutBinding> layout_bindings(uint32_t set);

}  // namespace weft::render

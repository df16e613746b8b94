// Purpose: the imports that a scene offers to graphs; needs no device. The draw lists opaque, masked and
// transparent together contain all draws; the list anisotropic repeats some of the first two. Further
// imports: their draw commands (opaqueCommands, …), the output image, the element types Light and
// DrawCommand, the views "camera" and "sun(0)" to "sun(3)", and the numbers directionalLights and
// environmentPictures.
#pragma once

#include <array>

#include "weft/imports.h"
#include "weft/scene/scene.h"

namespace weft::render {

inline constexpr std::array kDrawLists{"opaque", "masked", "transparent", "anisotropic"};
[[nodiscard]] bool is_in_draw_list(const scene::Material& material, std::string_view list);
// Index of the list's variant for draws with a material.
[[nodiscard]] uint32_t draw_variant(const scene::Material& material, std::string_view list);
// The import with a shared::DrawCommand for each draw of the list; it has one element if the list is empty.
[[nodiscard]] std::string commands_of(std::string_view list);

// The output is a UNORM image that the last pass encodes; after the frame the program copies, blits or reads
// it. Without a scene, every list has one draw, and there is one directional light and one environment
// picture.
[[nodiscard]] ImportCatalog scene_imports(Extent3D output_extent, const scene::Scene* scene = nullptr);

}  // namespace weft::render

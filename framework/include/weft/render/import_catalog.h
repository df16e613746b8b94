// Purpose: what a scene offers to graphs, known without a device: the draw lists opaque, masked and
// transparent, which are all draws, and anisotropic, which are some of the first two once more; their draw
// commands (opaqueCommands, …), the output image, the element types Light and DrawCommand, the views "camera"
// and "sun(0)" to "sun(3)", and the numbers directionalLights and environmentPictures.
#pragma once

#include <array>

#include "weft/imports.h"
#include "weft/scene/scene.h"

namespace weft::render {

inline constexpr std::array kDrawLists{"opaque", "masked", "transparent", "anisotropic"};
[[nodiscard]] bool is_in_draw_list(const scene::Material& material, std::string_view list);
// Where draws of a material are in the list's variants.
[[nodiscard]] uint32_t draw_variant(const scene::Material& material, std::string_view list);
// The import that holds a shared::DrawCommand for each draw of the list; of one, where there is none.
[[nodiscard]] std::string commands_of(std::string_view list);

// The output is a UNORM image that the last pass encodes; after the frame it is copied, blitted or read back.
// Without a scene every list has one draw, and there is one directional light and one environment picture.
[[nodiscard]] ImportCatalog scene_imports(Extent3D output_extent, const scene::Scene* scene = nullptr);

}  // namespace weft::render

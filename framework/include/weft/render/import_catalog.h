// Purpose: lists the imports that a scene offers to graphs; needs no device. Three draw lists, "opaque",
// "masked" and "transparent", together contain all draws of the scene. The draw list "anisotropic" repeats
// some draws of "opaque" and "masked", "coated" repeats those of their other draws that have a clear coat,
// "scattering" repeats those of the rest that let scattered light pass or whose diffuse reflection is rough,
// and the draw list "refractive" repeats the draws of "transparent" whose materials let light pass by
// transmission. The draw lists "opaqueStill" and "maskedStill" have the draws of "opaque" and "masked" whose
// objects do not move. Further imports: a buffer with the draw commands of each of the first four lists
// (opaqueCommands, …), buffers that describe the objects (instances, bounds, meshes, materials), the buffer
// sceneLights, the table materialTextures with the textures of all materials, the irradiance probes
// (render/probes/probe_imports.h), and the output image. The list of views "sun" has the cascades of the sun.
// "furtherSuns" has the views of the directional lights 2 to 4. "sceneSuns" has views of the directional
// lights 1 to 4 over all objects that do not move. "lampFaces" has the views of the scene's lamps, and
// "lampShadows" the views of their shadow maps. Graphs may also use the view "camera", the element types
// Light and DrawCommand, the element types of these buffers, and the numbers directionalLights,
// environmentPictures, outputIsLinear and irradianceProbes.
#pragma once

#include <array>

#include "weft/imports.h"
#include "weft/scene/probes.h"
#include "weft/scene/scene.h"

namespace weft::render {

inline constexpr std::array kDrawLists{"opaque",     "masked",     "transparent", "anisotropic", "coated",
                                       "scattering", "refractive", "opaqueStill", "maskedStill"};
// The lists whose draw commands graphs can import.
inline constexpr std::array kCommandLists{"opaque", "masked", "transparent", "anisotropic"};
// True if the list has no objects that move.
[[nodiscard]] bool is_still_list(std::string_view list);
// Returns true if the draw list contains the instance. An instance that only the program may move counts as
// an object that does not move, until the program moves it.
[[nodiscard]] bool is_in_draw_list(const scene::Instance& instance, const scene::Material& material,
                                   std::string_view list);
// Returns the index of the pipeline variant (ImportDecl::variants) for draws of the list with this material.
[[nodiscard]] uint32_t draw_variant(const scene::Material& material, std::string_view list);
// Returns the name of the import with the draw commands of a list: "opaqueCommands" for "opaque". It is a
// buffer with a shared::DrawCommand for each draw. For an empty list it has one element.
[[nodiscard]] std::string commands_of(std::string_view list);

// Returns true if the import of this name gives graphs access to the irradiance probes.
[[nodiscard]] bool is_probe_import(std::string_view name);

// Returns an import of kind "views" with `count` views.
[[nodiscard]] ImportDecl view_list(const std::string& name, uint32_t count);

// Returns the imports of a scene. The output is a UNORM image; the last pass of the graph writes encoded
// colours to it, and after the frame the program copies, blits or reads it. If `scene` is null, each list has
// one draw, and there is one view of a lamp, one directional light, one environment picture, and one
// probe of each kind. `probes`: those of the scene; null: none.
[[nodiscard]] ImportCatalog scene_imports(Extent3D output_extent, const scene::Scene* scene = nullptr,
                                          const scene::Probes* probes = nullptr);

}  // namespace weft::render

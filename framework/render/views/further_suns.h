// Purpose: computes the shadow maps of the directional lights 2 to 4, with one map for each. A map covers the
// sphere around the bounds of the scene, in a parallel projection along the light, so it changes only if the
// light moves. The map of a large scene is coarse. Light probes use further maps of this kind: one for each
// of the directional lights 1 to 4. These maps cover only the objects that do not move. Units: metres,
// texels.
#pragma once

#include <array>
#include <span>
#include <string>

#include "shared/frame.glsl"
#include "shared/further_suns.glsl"
#include "shared/light.glsl"
#include "weft/plan.h"
#include "weft/scene/scene.h"

namespace weft::render {

// Name of the list with the views of the directional lights 2 to 4.
inline constexpr const char* kFurtherSunViews = "furtherSuns";
// Name of the list with the views of the directional lights 1 to 4 over all objects that do not move.
inline constexpr const char* kSceneSunViews = "sceneSuns";

// The side of the map of each light in texels, or 0 if the graph does not draw it.
struct FurtherSunSizes {
    std::array<uint32_t, shared::kMostFurtherSuns> further{};
    std::array<uint32_t, shared::kMostSceneSuns> scene{};
};
// Returns the sizes of the maps that the passes of a plan draw.
[[nodiscard]] FurtherSunSizes further_sun_sizes(const FramePlan& plan);

struct FurtherSunMaps {
    shared::FurtherSuns constants{};
    // Element i has the view constants for passes with the view "furtherSuns(i)".
    std::array<shared::ViewConstants, shared::kMostFurtherSuns> views{};
    // Element i has the view constants for passes with the view "sceneSuns(i)".
    std::array<shared::ViewConstants, shared::kMostSceneSuns> scene_views{};
};
// `lights`: the lights in the order of the buffer, directional lights first. `bounds`: of all objects.
// `still_bounds`: of the objects that do not move.
[[nodiscard]] FurtherSunMaps further_sun_maps(std::span<const shared::Light> lights,
                                              const scene::Bounds& bounds, const scene::Bounds& still_bounds,
                                              const FurtherSunSizes& sizes_px);

}  // namespace weft::render

// Purpose: computes the shadow maps of the directional lights 2 to 4, with one map for each. A map covers the
// sphere around the bounds of the scene, in a parallel projection along the light, so it changes only if the
// light moves. The map of a large scene is coarse. Units: metres, texels.
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

// Name of the list with the views of these lights.
inline constexpr const char* kFurtherSunViews = "furtherSuns";

// The side of the map of each light in texels, or 0 if the graph does not draw it.
using FurtherSunSizes = std::array<uint32_t, shared::kMostFurtherSuns>;
// Returns the sizes of the maps that the passes of a plan draw.
[[nodiscard]] FurtherSunSizes further_sun_sizes(const FramePlan& plan);

struct FurtherSunMaps {
    shared::FurtherSuns constants{};
    // Element i has the view constants for passes with the view "furtherSuns(i)".
    std::array<shared::ViewConstants, shared::kMostFurtherSuns> views{};
};
// `lights`: the lights in the order of the buffer, directional lights first. `bounds`: of all objects.
[[nodiscard]] FurtherSunMaps further_sun_maps(std::span<const shared::Light> lights,
                                              const scene::Bounds& bounds, const FurtherSunSizes& sizes_px);

}  // namespace weft::render

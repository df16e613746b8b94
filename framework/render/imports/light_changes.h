// Purpose: finds the lights that differ between two frames, for the import "lightChanges". Units and layout:
// shaders/include/shared/light_change.glsl.
#pragma once

#include <span>
#include <vector>

#include "shared/light.glsl"
#include "shared/light_change.glsl"

namespace weft::render {

// Returns the changes, strongest first, at most shared::kMostLightChanges. A light that turns, or whose
// shape, cone or function changes, counts as a light that goes off and another light that goes on. If the
// lists have different lengths, the lights that are in only one of them have gone off or on.
[[nodiscard]] std::vector<shared::LightChange> light_changes(std::span<const shared::Light> before,
                                                             std::span<const shared::Light> now);

}  // namespace weft::render

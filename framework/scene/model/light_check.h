// Purpose: corrects lights from files and programs so that they can be drawn: finite values within the ranges
// below, cones of at most 90°, unit vectors. Units: those of scene.h.
#pragma once

#include <span>
#include <string>

#include "weft/result.h"
#include "weft/scene/scene.h"

namespace weft::scene {

inline constexpr uint32_t kMaxLights = 65'536;
inline constexpr uint32_t kMaxLightPictures = 64;

// Returns a text for users that lists the faults ("its range was negative"); empty when there were none. A
// light that cannot be corrected gets an intensity of 0.
[[nodiscard]] std::string clamp_light(Light& light);
[[nodiscard]] std::string clamp_light_function(LightFunction& function);

// One S158 per light that needs a correction; the first few are named.
[[nodiscard]] Diagnostics light_warnings(const Scene& scene);

}  // namespace weft::scene

// Purpose: clamps the numbers of a light, which a file or a program may set to anything: finite values within
// the ranges below, cones of at most 90°, unit vectors. Units: as in scene.h.
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

// S158 for each light and function of the scene with a fault. The first few are named, the rest is counted.
[[nodiscard]] Diagnostics light_warnings(const Scene& scene);

}  // namespace weft::scene

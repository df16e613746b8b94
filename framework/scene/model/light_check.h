// Purpose: makes lights that can be drawn of whatever a file or a program says: finite, within the ranges
// below, cones of at most 90°, unit vectors. Units: scene.h's.
#pragma once

#include <span>
#include <string>

#include "weft/result.h"
#include "weft/scene/scene.h"

namespace weft::scene {

inline constexpr uint32_t kMaxLights = 65'536;
inline constexpr uint32_t kMaxLightPictures = 64;

// What was wrong, for people ("its range was negative"); empty where nothing was. A light that can't be
// mended gets an intensity of 0.
[[nodiscard]] std::string mend(Light& light);
[[nodiscard]] std::string mend(LightFunction& function);

// S158 for each thing that would be mended in the scene, the first few of them by name.
[[nodiscard]] Diagnostics light_warnings(const Scene& scene);

}  // namespace weft::scene

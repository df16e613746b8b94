// Purpose: clamps the numbers of lights and light functions, because a file or a program may set them to any
// value. After clamping, all numbers that the light uses are finite and within limits, cone angles are at
// most 90° and directions are unit vectors. Units: as in scene.h.
#pragma once

#include <span>
#include <string>

#include "weft/result.h"
#include "weft/scene/scene.h"

namespace weft::scene {

inline constexpr uint32_t kMaxLights = 65'536;
inline constexpr uint32_t kMaxLightPictures = 64;

// Clamps a light or a light function. Returns a text for users that lists the corrected faults (such as "the
// intensity was out of range"); the text is empty if there were no faults. If the position of a light is not
// finite or too far away, the intensity of this light becomes 0.
[[nodiscard]] std::string clamp_light(Light& light);
[[nodiscard]] std::string clamp_light_function(LightFunction& function);

// Returns warnings S158 for the lights and light functions of the scene that have faults. Each of the first
// few faults has its own warning. One last warning gives only the number of the other faults.
[[nodiscard]] Diagnostics light_warnings(const Scene& scene);

}  // namespace weft::scene

// Purpose: the area of a lamp with a shape. glTF files give the intensity of such a lamp in candela; Light
// has its luminance, which is the intensity divided by this area. Units: m².
#pragma once

#include "weft/scene/scene.h"

namespace weft::scene {

// Returns the area of a rectangle or a capsule as seen from the direction in which it looks largest, for
// example from the front of a rectangle. `half_size_m`: see Light::half_size_m.
[[nodiscard]] inline float seen_area_m2(LightType shape, const glm::vec2& half_size_m) {
    const float a = half_size_m.x, b = half_size_m.y;
    return shape == LightType::rectangle ? 4 * a * b : b * (4 * a + 3.14159265f * b);
}

}  // namespace weft::scene

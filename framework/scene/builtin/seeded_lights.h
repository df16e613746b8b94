// Purpose: adds many lights to a scene: points and spots of all hues, distributed over its bounds with a
// seeded generator. Units: cd, metres. The same scene, count and seed give the same lights on every machine.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/scene/scene.h"

namespace weft::scene {

// Every second light is a spot. At `scene.exposure_ev` each light visibly lights its surroundings. Ranges are
// limited so that a few tens of lights reach any point.
[[nodiscard]] std::vector<Light> seeded_lights(const Scene& scene, uint32_t count, uint32_t seed);

// The same, but each light moves on its own horizontal ellipse within the bounds, once around in 4 to 12
// seconds.
[[nodiscard]] std::vector<Light> moving_lights(const Scene& scene, uint32_t count, uint32_t seed);

}  // namespace weft::scene

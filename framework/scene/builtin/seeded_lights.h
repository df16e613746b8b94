// Purpose: adds many lights to a scene: points and spots of all hues, distributed over its bounds with a
// seeded generator. Units: cd, metres. The same scene, count and seed give the same lights on every machine.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/scene/scene.h"

namespace weft::scene {

// Makes point lights and spots in turn. The illuminance at a quarter of the mean range is that of lamps at
// night, whatever else lights the scene. The ranges are limited, so that only a few tens of lights reach any point.
[[nodiscard]] std::vector<Light> seeded_lights(const Scene& scene, uint32_t count, uint32_t seed);

// Makes the lights of seeded_lights(), but brighter. Each light moves on its own horizontal ellipse within
// the bounds of the scene. One turn takes 4 to 12 seconds.
[[nodiscard]] std::vector<Light> moving_lights(const Scene& scene, uint32_t count, uint32_t seed);

}  // namespace weft::scene

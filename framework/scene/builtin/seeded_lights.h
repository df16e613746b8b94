// Purpose: many lights where a scene has few: points and spots of all hues, strewn over its bounds from a
// seed. Units: cd, metres. The same scene, count and seed give the same lights on every machine.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/scene/scene.h"

namespace weft::scene {

// Every second one a spot. So bright that at `scene.exposure_ev` a light shows what is around it, and with a
// range that lets each point be reached by some tens of them at most.
[[nodiscard]] std::vector<Light> seeded_lights(const Scene& scene, uint32_t count, uint32_t seed);

// The same, each on a level ellipse of its own within the bounds, once around in 4 to 12 seconds.
[[nodiscard]] std::vector<Light> moving_lights(const Scene& scene, uint32_t count, uint32_t seed);

}  // namespace weft::scene

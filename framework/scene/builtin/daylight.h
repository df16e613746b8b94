// Purpose: what lights the built-in scenes at an hour of their day: sun or moon, sky, and how far a
// photographer would open the lens. A look, not astronomy: nights are as bright against their exposure as
// films show them. Units: hours from 0 to 24, lux, cd/m², EV.
#pragma once

#include <glm/glm.hpp>

namespace weft::scene {

inline constexpr float kDefaultHour = 15;  // the sun reaches into the atrium's court

struct Daylight {
    glm::vec3 to_source{0, 1, 0};  // towards the sun, or at night the moon; unit length
    glm::vec3 color{1};
    float illuminance_lx = 0;
    glm::vec3 sky_zenith{0};
    glm::vec3 sky_horizon{0};
    float exposure_ev = 0;
    float lamps = 0;  // 0: off, 1: lit
};

[[nodiscard]] Daylight daylight_at(float hour);

}  // namespace weft::scene

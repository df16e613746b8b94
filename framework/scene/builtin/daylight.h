// Purpose: light of the built-in scenes at an hour of the day: sun or moon, sky, and the exposure that a
// photographer would choose. The aim is a good look, not astronomy: nights are as bright relative to their
// exposure as in films. Units: hours from 0 to 24, lux, cd/m², EV.
#pragma once

#include <glm/glm.hpp>

namespace weft::scene {

inline constexpr float kDefaultHour = 15;  // at this hour the sun shines into the atrium's court

struct Daylight {
    glm::vec3 to_source{0, 1, 0};  // unit vector towards the sun, or at night towards the moon
    glm::vec3 color{1};
    float illuminance_lx = 0;
    glm::vec3 sky_zenith{0};
    glm::vec3 sky_horizon{0};
    float exposure_ev = 0;
    float lamps = 0;  // 0: off, 1: lit
};

[[nodiscard]] Daylight daylight_at(float hour);

}  // namespace weft::scene

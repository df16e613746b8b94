// Purpose: light of the built-in scenes "atrium" and "lights" at an hour of the day: sun or moon, sky, lamps,
// and a suitable exposure. The aim is a pleasing picture, not astronomy: at night the moon and the sky are
// about 15 times as bright as in reality, as in films. Units: hours from 0 to 24, lux, cd/m², EV.
#pragma once

#include <glm/glm.hpp>

namespace weft::scene {

// Hour of the day if the user selects none, in hours. At this hour the sun shines into the atrium's court.
inline constexpr float kDefaultHour = 15;

struct Daylight {
    glm::vec3 to_source{0, 1, 0};  // Unit vector towards the sun, or towards the moon at night.
    glm::vec3 color{1};
    float illuminance_lx = 0;
    glm::vec3 sky_zenith{0};
    glm::vec3 sky_horizon{0};
    float exposure_ev = 0;
    float lamps = 0;  // Brightness of the lamps: 0 is off, 1 is fully lit.
};

[[nodiscard]] Daylight daylight_at(float hour);

}  // namespace weft::scene

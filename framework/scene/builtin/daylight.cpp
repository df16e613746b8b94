#include "scene/builtin/daylight.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/model/angles.h"

namespace weft::scene {
namespace {

constexpr float kSunrise = 6, kSunset = 19;
// Hours at which the light source changes: before dawn and after dusk the moon is the light source, between
// them the sun.
constexpr float kDawn = 6.2f, kDusk = 19.3f;
constexpr float kHighestSine = 0.785f;  // Sine of the sun's elevation at its highest point.
constexpr float kEvening = 17;
// Azimuth of the sun at the hour kEvening: the angle from +z towards +x, in radians.
constexpr float kEveningAzimuth = -0.770f;

// The light at one hour of the day. daylight_at() interpolates between two neighbouring keys.
struct Key {
    float hour;
    glm::vec3 color;
    float illuminance_lx;
    glm::vec3 sky_zenith;
    glm::vec3 sky_horizon;
    float exposure_ev;
    float lamps;
};

constexpr glm::vec3 kMoonlight{0.62f, 0.74f, 1};
constexpr std::array kKeys{
    Key{0, kMoonlight, 3.75f, {0.19f, 0.38f, 1}, {0.75f, 1.06f, 1.9f}, -4.3f, 1},
    Key{4.4f, kMoonlight, 2.5f, {0.19f, 0.38f, 1}, {0.75f, 1.06f, 1.9f}, -4.3f, 1},
    Key{kDawn, {1, 0.6f, 0.35f}, 0, {60, 90, 190}, {700, 420, 320}, -9.6f, 0.6f},
    Key{7.5f, {1, 0.72f, 0.45f}, 5000, {260, 520, 1300}, {1900, 1700, 1500}, -11.4f, 0},
    Key{12, {1, 0.95f, 0.88f}, 24000, {380, 950, 2700}, {2100, 2600, 3100}, -12.6f, 0},
    Key{kEvening, {1, 0.80f, 0.54f}, 11000, {330, 800, 2200}, {1900, 2250, 2600}, -12, 0},
    Key{18.6f, {1, 0.55f, 0.28f}, 3500, {170, 300, 800}, {1700, 1000, 600}, -10.9f, 0.3f},
    Key{kDusk, {1, 0.5f, 0.3f}, 0, {50, 80, 210}, {620, 360, 330}, -9.4f, 0.8f},
    Key{21.1f, kMoonlight, 2.75f, {0.24f, 0.48f, 1.32f}, {1.15f, 1.4f, 2.4f}, -4.4f, 1},
    Key{24, kMoonlight, 3.75f, {0.19f, 0.38f, 1}, {0.75f, 1.06f, 1.9f}, -4.3f, 1},
};

// Interpolates the logarithms, because the light of the sky falls by nearly equal factors in equal times at
// dusk.
glm::vec3 mix_by_factors(const glm::vec3& a, const glm::vec3& b, float t) {
    return glm::exp2(glm::mix(glm::log2(a), glm::log2(b), t));
}

glm::vec3 towards(float sine_of_elevation, float azimuth) {
    const float cosine = std::sqrt(1 - sine_of_elevation * sine_of_elevation);
    return {cosine * std::sin(azimuth), sine_of_elevation, cosine * std::cos(azimuth)};
}

glm::vec3 to_source_at(float hour) {
    if (hour < kDawn || hour > kDusk) return towards(0.8f, 0.9f);
    const float share = (hour - kSunrise) / (kSunset - kSunrise);
    const float sine = kHighestSine * std::sin(kPi * share);
    return towards(std::max(sine, 0.02f), kEveningAzimuth + (kEvening - hour) * kPi / 12);
}

}  // namespace

Daylight daylight_at(float hour) {
    hour = std::clamp(hour, 0.0f, 24.0f);
    const auto after = std::upper_bound(kKeys.begin() + 1, kKeys.end() - 1, hour,
                                        [](float h, const Key& key) { return h < key.hour; });
    const Key &a = *(after - 1), &b = *after;
    const float t = (hour - a.hour) / (b.hour - a.hour);
    Daylight light;
    light.to_source = to_source_at(hour);
    light.color = glm::mix(a.color, b.color, t);
    light.illuminance_lx = glm::mix(a.illuminance_lx, b.illuminance_lx, t);
    light.sky_zenith = mix_by_factors(a.sky_zenith, b.sky_zenith, t);
    light.sky_horizon = mix_by_factors(a.sky_horizon, b.sky_horizon, t);
    light.exposure_ev = glm::mix(a.exposure_ev, b.exposure_ev, t);
    light.lamps = glm::mix(a.lamps, b.lamps, t);
    return light;
}

}  // namespace weft::scene

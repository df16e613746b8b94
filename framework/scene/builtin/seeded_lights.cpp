#include "scene/builtin/seeded_lights.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "scene/model/angles.h"

namespace weft::scene {
namespace {

// Mean number of lights that reach a point of the scene.
constexpr float kOverlap = 24;
// Illuminance of a light at a quarter of its mean range. There a surface with an albedo of 50 % has a
// luminance of 3.7 cd/m², as a wall in a room with lamps at night.
constexpr float kIlluminance_lx = 23;
// Factor for the intensity of moving lights. The built-in scene "lights" has no other lights, and its default
// hour is at night, so its lights are brighter.
constexpr float kNightGain = 6;

// Random numbers that are the same on every machine. std::uniform_real_distribution gives different numbers
// in different standard libraries; std::mt19937 does not.
class LightRandom {
 public:
    explicit LightRandom(uint32_t seed) : engine_(seed) {}
    float unit() { return static_cast<float>(engine_() >> 8u) / 16777216.0f; }
    glm::vec3 direction() {
        const float z = 2 * unit() - 1, turn = 2 * kPi * unit(), r = std::sqrt(std::max(0.0f, 1 - z * z));
        return {r * std::cos(turn), r * std::sin(turn), z};
    }

 private:
    std::mt19937 engine_;
};

// Returns a colour of the hue `turn` in [0, 1). Each channel is at least 0.1, so that no colour looks black.
glm::vec3 hue(float turn) {
    const glm::vec3 phase = 2 * kPi * (glm::vec3(turn) + glm::vec3(0, 1, 2) / 3.0f);
    return 0.55f + 0.45f * glm::vec3(std::cos(phase.x), std::cos(phase.y), std::cos(phase.z));
}

// Returns the radius of a sphere that contains kOverlap lights on average, if `count` lights are distributed
// over a box of this size. The radius is at most the diagonal of the box.
float range_for(glm::vec3 size, uint32_t count) {
    const float volume = std::max(size.x * size.y * size.z, 1e-3f);
    const float share = volume * kOverlap / static_cast<float>(count);
    return std::min(std::cbrt(share * 3 / (4 * kPi)), glm::length(size));
}

}  // namespace

std::vector<Light> seeded_lights(const Scene& scene, uint32_t count, uint32_t seed) {
    LightRandom random(seed);
    const glm::vec3 size = scene.bounds.max - scene.bounds.min;
    const float range_m = range_for(size, count);
    std::vector<Light> lights(count);
    for (uint32_t i = 0; i < count; ++i) {
        Light& light = lights[i];
        light.name = "light " + std::to_string(i);
        const float x = random.unit(), y = random.unit(), z = random.unit();
        light.position = scene.bounds.min + size * glm::vec3(x, y, z);
        light.color = hue(random.unit());
        light.direction = random.direction();
        light.range_m = range_m * (0.5f + random.unit());
        light.intensity = kIlluminance_lx * range_m * range_m / 16;
        if (i % 2 == 0) continue;
        light.type = LightType::spot;
        light.outer_cone_rad = 0.3f + 0.6f * random.unit();
        light.inner_cone_rad = 0.7f * light.outer_cone_rad;
    }
    return lights;
}

std::vector<Light> moving_lights(const Scene& scene, uint32_t count, uint32_t seed) {
    std::vector<Light> lights = seeded_lights(scene, count, seed);
    LightRandom random(seed ^ 0x9e3779b9u);
    for (Light& light : lights) {
        const glm::vec3 room = glm::min(light.position - scene.bounds.min, scene.bounds.max - light.position);
        const float nearest = std::min(room.x, room.z), turn = 2 * kPi * random.unit();
        const float x = nearest * random.unit(), z = nearest * random.unit();
        // The path is an ellipse whose axes are parallel to x and z. Both half axes are at most the distance
        // from the light to the nearest vertical side of the scene's bounds. So the light stays inside the
        // bounds.
        light.path.across = {x * std::cos(turn), 0, z * std::sin(turn)};
        light.path.along = {-x * std::sin(turn), 0, z * std::cos(turn)};
        light.path.turns_per_s = (random.unit() < 0.5f ? -1.0f : 1.0f) / (4 + 8 * random.unit());
        light.path.phase = random.unit();
        light.intensity *= kNightGain;
    }
    return lights;
}

}  // namespace weft::scene

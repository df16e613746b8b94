// Purpose: test fixture that measures lights at 8 × 8 points of the plane y = 0. The points are one metre
// apart. It measures the irradiance, and the light that a white metal at each point reflects.
#pragma once

#include <span>

#include "tests/render/session_fixture.h"

namespace weft::test {

inline constexpr size_t kPoints = 64;

inline glm::dvec3 point_of(size_t i) {
    return {static_cast<double>(i % 8) - 3.5, 0, static_cast<double>(i / 8) - 3.5};
}

inline const glm::dvec3 kUp(0, 1, 0);

struct Measured {
    std::vector<shared::Light> lights;
    // kPoints values for each light, one light after another.
    std::vector<glm::vec4> irradiance;
    // kPoints values for each light. The channels are radiances for the four roughnesses in irradiance.json.
    std::vector<glm::vec4> highlight;
    [[nodiscard]] glm::dvec3 at(size_t light, size_t point) const {
        return glm::dvec3(irradiance[light * kPoints + point]);
    }
};

class Irradiance : public SessionTest {
 protected:
    Measured measure(std::vector<scene::Light> lights, std::vector<scene::LightFunction> functions = {}) {
        scene::Scene scene;
        scene.lights = std::move(lights);
        scene.light_functions = std::move(functions);
        return measure(std::move(scene));
    }
    Measured measure(scene::Scene scene) {
        scene.bounds.min = glm::vec3(-4);
        scene.bounds.max = glm::vec3(4);
        const Rendered r =
            render(scene, scene::framing_camera(scene, 1), {16, 16, 1}, 0, {"irradiance", "highlight"},
                   WEFT_SOURCE_DIR "/tests/render/irradiance/irradiance.json");
        if (r.images.size() != 2) return {};
        return {r.lights, r.images.at("irradiance"), r.images.at("highlight")};
    }
};

inline scene::Light light_of(scene::LightType type, glm::vec3 position, glm::vec3 direction,
                             float intensity = 1) {
    scene::Light light;
    light.type = type;
    light.position = position;
    light.direction = glm::normalize(direction);
    light.intensity = intensity;
    return light;
}

// The members that a test sets in a capsule or rectangle light; see scene::Light.
struct Placement {
    const char* name;
    glm::vec3 position;
    glm::vec3 direction;    // For a capsule, its axis.
    glm::vec3 side;         // Direction of a rectangle's width.
    glm::vec2 half_size_m;  // Rectangle: half width and half height. Capsule: half length and radius.
    float range_m = 0;      // 0: unlimited.
};

inline std::vector<scene::Light> placed(scene::LightType type, std::span<const Placement> placements) {
    std::vector<scene::Light> lights;
    for (const Placement& p : placements) {
        lights.push_back(light_of(type, p.position, p.direction));
        lights.back().name = p.name;
        lights.back().side = p.side;
        lights.back().half_size_m = p.half_size_m;
        lights.back().range_m = p.range_m;
    }
    return lights;
}

}  // namespace weft::test

#include "scene/model/node_placement.h"

#include <cmath>

namespace weft::scene {
namespace {

constexpr float kMaxEntry = 1e15f;

glm::vec3 unit_direction_or(const glm::vec3& v, const glm::vec3& fallback) {
    const float length = glm::length(v);
    return std::isfinite(length) && length > 1e-20f ? v / length : fallback;
}

// Returns the part of `v` perpendicular to the unit vector `direction`, normalised. If this part is zero, the
// result is any unit vector perpendicular to `direction`.
glm::vec3 across_or(const glm::vec3& v, const glm::vec3& direction) {
    const glm::vec3 unit = unit_direction_or(v, {1, 0, 0});
    const glm::vec3 steep = std::abs(direction.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 across = unit - direction * glm::dot(unit, direction);
    return glm::length(across) > 1e-3f ? glm::normalize(across)
                                       : glm::normalize(glm::cross(direction, steep));
}

}  // namespace

bool is_usable_transform(const glm::mat4& m) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!(std::abs(m[column][row]) <= kMaxEntry)) return false;
        }
    }
    return true;
}

glm::mat4 invisible_transform() {
    glm::mat4 none(0.0f);
    none[3][3] = 1;
    return none;
}

glm::vec4 unit_quaternion(const glm::vec4& xyzw) {
    const float length = glm::length(xyzw);
    return std::isfinite(length) && length > 1e-6f ? xyzw / length : glm::vec4(0, 0, 0, 1);
}

void place_light(const glm::mat4& world, Light& light) {
    light.position = glm::vec3(world[3]);
    const glm::vec3 forward = unit_direction_or(-glm::vec3(world[2]), {0, 0, -1});
    const glm::vec3 width = across_or(glm::vec3(world[0]), forward);
    light.direction = light.type == LightType::capsule ? width : forward;
    light.side = light.type == LightType::capsule ? forward : width;
}

glm::mat4 rigid_transform(const glm::mat4& world) {
    const glm::vec3 back = unit_direction_or(glm::vec3(world[2]), {0, 0, 1});
    const glm::vec3 steep = std::abs(back.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 right =
        unit_direction_or(glm::cross(glm::vec3(world[1]), back), unit_direction_or(glm::cross(steep, back), {1, 0, 0}));
    return {glm::vec4(right, 0), glm::vec4(glm::cross(back, right), 0), glm::vec4(back, 0), world[3]};
}

void apply_pose(const std::vector<glm::mat4>& nodes, Scene& scene) {
    for (Instance& instance : scene.instances)
        if (instance.node != kNone) instance.transform = nodes[instance.node];
    for (Light& light : scene.lights)
        if (light.node != kNone) place_light(nodes[light.node], light);
    for (Camera& camera : scene.cameras)
        if (camera.node != kNone) camera.transform = rigid_transform(nodes[camera.node]);
}

}  // namespace weft::scene

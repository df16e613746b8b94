#include "weft/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weft::scene {

glm::vec3 position_at(const Light& light, double time_s) {
    const LightPath& path = light.path;
    if (path.turns_per_s == 0) return light.position;
    const double turns = double{path.phase} + double{path.turns_per_s} * time_s;
    const double angle = 6.283185307179586 * (turns - std::floor(turns));
    return light.position + path.across * static_cast<float>(std::cos(angle)) +
           path.along * static_cast<float>(std::sin(angle));
}
namespace {

// Distance of the default camera from the centre of the scene, in radii of the scene's bounding sphere.
constexpr float kFramingDistance = 1.9f;

// If the instances of a scene have more vertices than this limit, the bounds of the scene are computed from
// the corners of each mesh's bounding box instead of from all vertices. This saves time.
constexpr uint64_t kMaxExactVertices = 100'000'000;

uint64_t instanced_vertices(const Scene& scene) {
    uint64_t total = 0;
    for (const Instance& instance : scene.instances) total += scene.meshes[instance.mesh].positions.size();
    return total;
}

void grow(Bounds& bounds, const glm::mat4& transform, const glm::vec3& position) {
    const glm::vec3 world(transform * glm::vec4(position, 1));
    bounds.min = glm::min(bounds.min, world);
    bounds.max = glm::max(bounds.max, world);
}

// Returns the bounds of all instances if `moving` is true, otherwise only of the instances that do not move.
std::optional<Bounds> bounds_of(const Scene& scene, bool moving) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    Bounds bounds{glm::vec3(kInfinity), glm::vec3(-kInfinity)};
    const bool exact = instanced_vertices(scene) <= kMaxExactVertices;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        if (mesh.positions.empty() || (!moving && instance.node != kNone)) continue;
        if (exact) {
            for (const glm::vec3& position : mesh.positions) grow(bounds, instance.transform, position);
            continue;
        }
        for (int corner = 0; corner < 8; ++corner) {
            grow(bounds, instance.transform,
                 {(corner & 1) != 0 ? mesh.bounds.max.x : mesh.bounds.min.x,
                  (corner & 2) != 0 ? mesh.bounds.max.y : mesh.bounds.min.y,
                  (corner & 4) != 0 ? mesh.bounds.max.z : mesh.bounds.min.z});
        }
    }
    if (!(bounds.min.x <= bounds.max.x)) return std::nullopt;
    return bounds;
}

}  // namespace

Bounds world_bounds(const Scene& scene) {
    return bounds_of(scene, true).value_or(Bounds{});
}

std::optional<Bounds> fixed_bounds(const Scene& scene) {
    return bounds_of(scene, false);
}

Camera framing_camera(const Scene& scene, float aspect) {
    const Bounds bounds = world_bounds(scene);
    const glm::vec3 centre = (bounds.min + bounds.max) * 0.5f;
    const float half_diagonal = glm::length(bounds.max - bounds.min) * 0.5f;
    const float radius = half_diagonal > 0 ? half_diagonal : 1.0f;
    const glm::vec3 back = glm::normalize(glm::vec3(0.9f, 0.75f, 1.3f));
    const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), back));
    Camera camera;
    camera.name = "framing";
    camera.transform =
        glm::mat4(glm::vec4(right, 0), glm::vec4(glm::cross(back, right), 0), glm::vec4(back, 0),
                  glm::vec4(centre + back * (kFramingDistance * radius), 1));
    // Half of the horizontal field of view for a landscape or square picture: 22.5° in radians.
    constexpr float kHalfHorizontal = 0.39269908170f;
    // In a portrait picture the width limits the view: the horizontal field of view must contain the scene's
    // bounding sphere. From a distance of 1.9 radii, the angle between the centre of the sphere and its edge
    // is asin(1 / 1.9).
    static const float kHalfSphere = std::asin(1 / kFramingDistance);
    const float half_horizontal = aspect < 1 ? kHalfSphere : kHalfHorizontal;
    camera.fov_y_rad = 2 * std::atan(std::tan(half_horizontal) / std::max(aspect, 1e-6f));
    // The nearest point of the scene's bounding sphere is 0.9 radii away, so a near plane at 0.01 radii cuts
    // nothing off.
    camera.near_m = radius * 0.01f;
    return camera;
}

}  // namespace weft::scene

// Computes the camera of a path at a time.
#include "weft/scene/camera_path.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace weft::scene {
namespace {

// A curve can leave the range of its keys. So the field of view is limited again, to .01° and 179°.
constexpr float kLeastFieldOfView = 1.7e-4f, kMostFieldOfView = 3.125f;

}  // namespace

Camera camera_looking_at(const glm::vec3& eye, const glm::vec3& at, float fov_y_rad) {
    const glm::vec3 forward = glm::normalize(at - eye);
    const glm::vec3 up = std::abs(forward.y) > 0.999f ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
    Camera camera;
    camera.transform = glm::inverse(glm::lookAt(eye, at, up));
    camera.fov_y_rad = fov_y_rad;
    return camera;
}

size_t shot_at(const CameraPath& path, double time_s) {
    const auto later = std::ranges::upper_bound(
        path.shots, time_s, {}, [](const CameraShot& shot) { return double{shot.eye.times_s.front()}; });
    return static_cast<size_t>(std::max<std::ptrdiff_t>(later - path.shots.begin(), 1) - 1);
}

Camera camera_at(const CameraPath& path, double time_s) {
    const CameraShot& shot = path.shots[shot_at(path, time_s)];
    const glm::vec3 eye(value_at(shot.eye, time_s));
    glm::vec3 at(value_at(shot.at, time_s));
    // Between two keys, the camera can pass through the point that it looks at. There, it looks along −z.
    if (!(glm::distance(eye, at) > 1e-6f * std::max(1.0f, glm::length(eye)))) at = eye - glm::vec3(0, 0, 1);
    const float fov_y_rad =
        std::clamp(value_at(shot.field_of_view, time_s).x, kLeastFieldOfView, kMostFieldOfView);
    Camera camera = camera_looking_at(eye, at, fov_y_rad);
    camera.name = "path";
    return camera;
}

}  // namespace weft::scene

// Purpose: a camera that moves along keys over time, read from a JSON file that docs/command-line.md
// describes. Units: seconds, metres, degrees in the file and radians here. Errors: S195 a wrong value in the
// file; W001 to W005 the file is not JSON.
#pragma once

#include <string>
#include <vector>

#include "weft/file_reader.h"
#include "weft/result.h"
#include "weft/scene/motion.h"
#include "weft/scene/scene.h"

namespace weft::scene {

inline constexpr size_t kMostCameraKeys = 10'000;

// Keys between which the camera moves without a cut. Each of the samplers has a key at the same times.
struct CameraShot {
    MotionSampler eye;            // xyz: the position of the camera. w is not used.
    MotionSampler at;             // xyz: the point that the camera looks at. w is not used.
    MotionSampler field_of_view;  // x: the vertical field of view in radians. The other values are not used.
};

// At least one shot. At the first key of each later shot, the camera jumps to this key.
struct CameraPath {
    std::vector<CameraShot> shots;
};

// Returns a camera at `eye` that looks at `at`, with the y axis of the world upwards in the picture. If the
// camera looks straight up or down, the −z axis of the world is upwards instead. `eye` and `at` must differ.
[[nodiscard]] Camera camera_looking_at(const glm::vec3& eye, const glm::vec3& at, float fov_y_rad);

// Returns the index of the shot at a time. Before the first key, it is 0.
[[nodiscard]] size_t shot_at(const CameraPath& path, double time_s);

// Returns the camera at a time. Before the first key and after the last key of the path, the camera stands at
// this key. It also stands between the last key of a shot and the first key of the next shot.
[[nodiscard]] Camera camera_at(const CameraPath& path, double time_s);

[[nodiscard]] Result<CameraPath> read_camera_path(const std::string& file, const FileReader& reader);

}  // namespace weft::scene

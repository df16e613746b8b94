// Purpose: opens the scene and camera for the command line's SCENE, --camera, --env, --time and --lights.
// Errors: S… of the loaders; S130 unknown camera, X520 malformed camera, X521 a scene without time of day,
// X522 a graph in place of a scene.
#pragma once

#include <optional>
#include <string>

#include "weft/declaration.h"
#include "weft/limits.h"
#include "weft/result.h"
#include "weft/scene/scene.h"

namespace weft::viewer {

struct SceneChoice {
    std::string name;
    std::string env = "sky";
    std::optional<float> hour;       // time of day, for a built-in scene that supports it
    std::optional<uint32_t> lights;  // number of seeded lights
    uint32_t seed = 1;
};

// `scene` is a .gltf or .glb, a folder that contains one, or "builtin:NAME". `env` is "sky", "none" or a
// Radiance picture. With a sky, a scene without any light gets a sun, so that it is visible. Seeded lights
// replace the scene's own lights; those of builtin:lights move.
[[nodiscard]] Result<scene::Scene> open_scene(const SceneChoice& choice, const SceneLimits& limits,
                                              Diagnostics& warnings);

// X522 if `name` is a graph, given as the scene by mistake.
[[nodiscard]] Status expect_scene(const std::string& name);

[[nodiscard]] inline float aspect_of(Extent3D size) {
    return static_cast<float>(size.width) / static_cast<float>(size.height);
}

struct CameraChoice {
    std::string scene;   // same value as in SceneChoice
    std::string camera;  // a name, seven numbers EYE_X,EYE_Y,EYE_Z,AT_X,AT_Y,AT_Z,FOVY_DEG, or empty
    float aspect = 1;    // width / height of the picture
};

// An empty choice selects the scene's first camera, or a camera that shows the whole scene. For a portrait
// picture, the first camera of a built-in scene keeps the horizontal view of a 4:3 picture, unless the camera
// is inside the scene.
[[nodiscard]] Result<scene::Camera> choose_camera(const scene::Scene& scene, const CameraChoice& choice);

}  // namespace weft::viewer

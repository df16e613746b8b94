// Purpose: from the command line's SCENE, --camera, --env, --time and --lights to a scene and a camera.
// Errors: S… of the loaders; S130 unknown camera, X520 malformed camera, X521 a scene without hours, X522 a
// graph in place of a scene.
#pragma once

#include <optional>
#include <string>

#include "weft/limits.h"
#include "weft/result.h"
#include "weft/scene/scene.h"

namespace weft::viewer {

struct SceneChoice {
    std::string name;
    std::string env = "sky";
    std::optional<float> hour;       // of a built-in scene that has a day
    std::optional<uint32_t> lights;  // that many seeded ones
    uint32_t seed = 1;
};

// A .gltf or .glb, a folder that holds one, or "builtin:NAME". `env` is "sky", "none" or a Radiance picture.
// With a sky, a scene that brings no light at all gets a sun, so that it can be seen. Seeded lights take
// the place of the scene's own; those of builtin:lights move.
[[nodiscard]] Result<scene::Scene> open_scene(const SceneChoice& choice, const SceneLimits& limits,
                                              Diagnostics& warnings);

// A graph that was named as the scene, by a slip.
[[nodiscard]] Status expect_scene(const std::string& name);

struct CameraChoice {
    std::string scene;   // as in SceneChoice
    std::string camera;  // a name, seven numbers EYE_X,EYE_Y,EYE_Z,AT_X,AT_Y,AT_Z,FOVY_DEG, or empty
    float aspect = 1;    // of the picture: width / height
};

// An empty choice is the scene's first camera, or one that frames the scene's bounds. The first camera of a
// built-in scene shows in a portrait as much from side to side as in a picture of 4:3, unless it stands
// inside the scene.
[[nodiscard]] Result<scene::Camera> choose_camera(const scene::Scene& scene, const CameraChoice& choice);

}  // namespace weft::viewer

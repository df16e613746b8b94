// Purpose: opens the scene and chooses the camera for the arguments SCENE, --camera, --env, --time and
// --lights. Errors: S130 (unknown camera), X520 (malformed camera), X521 (the scene has no time of day), X522
// (the file is a graph and not a scene), and the other errors S... of the loaders.
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
    std::optional<float> hour;       // Hour of the day, 0 to 24, for a built-in scene that has a time of day.
    std::optional<uint32_t> lights;  // Number of generated lights that replace the lights of the scene.
    uint32_t seed = 1;
    float env_gain = 1;  // Factor of the values of the environment picture.
};

// Opens a scene. The name is a .gltf or .glb file, a folder that contains such a file, or "builtin:NAME". The
// environment `env` is "sky", "none" or the path of a Radiance picture. With "sky", a scene without its own
// sky gets the default sky, and also a sun if it has no lights. If `lights` is set, generated lights replace
// the lights of the scene. In builtin:lights the generated lights move. The suns of the environment picture
// become directional lights, which follow the other lights in the list.
[[nodiscard]] Result<scene::Scene> open_scene(const SceneChoice& choice, const SceneLimits& limits,
                                              Diagnostics& warnings);

// Returns the error X522 if the file `name` is a graph, which the user gave as the scene by mistake.
[[nodiscard]] Status expect_scene(const std::string& name);

[[nodiscard]] inline float aspect_of(Extent3D size) {
    return static_cast<float>(size.width) / static_cast<float>(size.height);
}

struct CameraChoice {
    std::string scene;  // Name of the scene, with the same value as SceneChoice::name.
    // Name of a camera in the scene, or seven numbers EYE_X,EYE_Y,EYE_Z,AT_X,AT_Y,AT_Z,FOVY_DEG, or empty.
    std::string camera;
    float aspect = 1;  // Width divided by height of the picture.
};

// Returns the chosen camera. If `choice.camera` is empty, this is the first camera of the scene. If the scene
// has none, it is a camera that shows the whole scene. In a portrait picture, the first camera of a built-in
// scene keeps the horizontal field of view of a 4:3 picture, unless the camera is inside the scene.
[[nodiscard]] Result<scene::Camera> choose_camera(const scene::Scene& scene, const CameraChoice& choice);

}  // namespace weft::viewer

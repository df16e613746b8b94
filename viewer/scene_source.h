// Purpose: from the command line's SCENE, --camera and --env to a scene and a camera.
// Errors: S… of the loaders; S130 unknown camera, X520 malformed camera.
#pragma once

#include <string>

#include "scene/scene.h"
#include "weft/result.h"

namespace weft::viewer {

// A .gltf or .glb, a folder that holds one, or "builtin:NAME". `env` is "sky", "none" or a Radiance picture.
// With a sky, a scene that brings no light at all gets a sun, so that it can be seen.
[[nodiscard]] Result<scene::Scene> open_scene(const std::string& name, const std::string& env,
                                              Diagnostics& warnings);

// A camera of the scene by name, seven numbers EYE_X,EYE_Y,EYE_Z,AT_X,AT_Y,AT_Z,FOVY_DEG, or, when `choice`
// is empty, the scene's first camera or one that frames its bounds. `aspect` is width / height.
[[nodiscard]] Result<scene::Camera> choose_camera(const scene::Scene& scene, const std::string& choice,
                                                  float aspect);

}  // namespace weft::viewer

// Purpose: the scenes that come with Weft, made in code so that a first picture needs no download.
//   "atrium": a colonnade around a court, for pictures. "spheres": roughness × metalness under one light, for
//   numbers. "cornell" and "mirror": light between surfaces.
// Guarantees: the same bytes on every run; lights in photometric units; textures with full mip chains.
// Errors: S120, a name that is not a built-in scene.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "weft/result.h"

namespace weft::scene {

[[nodiscard]] std::vector<std::string> builtin_scene_names();
[[nodiscard]] Result<Scene> make_builtin(std::string_view name);

}  // namespace weft::scene

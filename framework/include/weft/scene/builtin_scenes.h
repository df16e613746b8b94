// Purpose: the scenes that come with Weft, made in code so that a first picture needs no download.
//   "atrium": a colonnade around a court, for pictures. "spheres": roughness × metalness under one light, for
//   numbers. "cornell" and "mirror": light between surfaces. "brushed": metal with a grain. "lights": the
//   atrium at night under many lights that move. "stage": what lamps can be.
// Guarantees: the same bytes on every run; lights in photometric units; textures with full mip chains.
// Errors: S120, a name that is not a built-in scene.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "weft/result.h"
#include "weft/scene/scene.h"

namespace weft::scene {

struct BuiltinOptions {
    std::optional<float> hour;  // of the day, 0 to 24, where the scene has one: kDefaultHour, in "lights" 22
    uint32_t lights = 256;      // of "lights"
    uint32_t seed = 1;          // of "lights"
};

[[nodiscard]] std::vector<std::string> builtin_scene_names();
[[nodiscard]] bool has_hours(std::string_view name);
[[nodiscard]] Result<Scene> make_builtin(std::string_view name, const BuiltinOptions& options = {});

}  // namespace weft::scene

// Purpose: the scenes that are part of Weft. Code generates them, so that the first picture needs no
// download.
//   "atrium": a colonnade around a court, for pictures
//   "spheres": roughness × metalness under one light, for measurements
//   "cornell" and "mirror": light between surfaces
//   "brushed": anisotropic metal
//   "lights": the atrium at night with many moving lights
//   "materials": hair, silk, ice, paper and plaster
//   "stage": all kinds of lamps
// Every run makes the same bytes. Lights have photometric units, and textures have full mip chains.
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
    // Hour of the day, 0 to 24, for the scenes "atrium" (default: 15) and "lights" (default: 22).
    std::optional<float> hour;
    uint32_t lights = 256;  // Number of lights in the scene "lights".
    uint32_t seed = 1;      // Seed of the random numbers for the scene "lights".
};

[[nodiscard]] std::vector<std::string> builtin_scene_names();
[[nodiscard]] bool has_hours(std::string_view name);
[[nodiscard]] Result<Scene> make_builtin(std::string_view name, const BuiltinOptions& options = {});

}  // namespace weft::scene

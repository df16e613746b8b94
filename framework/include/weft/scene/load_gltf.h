// Purpose: loads a glTF 2.0 file as a Scene. The file is not trusted: no file outside its folder is opened,
// every count is compared with the available bytes before it is used, and every total has a limit. Units: as
// in scene.h, which are those of glTF (metres, radians, candela, lux). emissiveFactor × emissiveStrength is
// interpreted as cd/m². Errors: S101…S149, each with the file and a JSON pointer; X571 if memory is
// exhausted. Warnings: S150…S199, for parts of the file that were ignored or corrected. Source: "glTF 2.0
// Specification", Khronos Group, 2021, and the KHR extensions that it links to.
#pragma once

#include <cstdint>
#include <filesystem>

#include "weft/limits.h"
#include "weft/result.h"
#include "weft/scene/load_progress.h"
#include "weft/scene/scene.h"

namespace weft::scene {

using weft::SceneLimits;

// Loads a scene. `file_or_folder` is a .gltf file, a .glb file, or a folder that contains exactly one such
// file.
[[nodiscard]] Result<Scene> load_gltf(const std::filesystem::path& file_or_folder, Diagnostics& warnings,
                                      const SceneLimits& limits = {}, const LoadOptions& options = {});

}  // namespace weft::scene

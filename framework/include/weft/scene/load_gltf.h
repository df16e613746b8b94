// Purpose: a glTF 2.0 file as a Scene. The file is treated as hostile: nothing outside its folder is opened,
// no count in it is believed before it was compared with the bytes that are there, and every total has a
// limit. Units: as in scene.h; glTF's own (metres, radians, candela, lux) are the same. emissiveFactor times
// emissiveStrength is read as cd/m².
// Errors: S101…S149, each with the file and a JSON pointer; X571 where memory ran out. Warnings: S150…S199,
// for what was left out or mended. Source: "glTF 2.0 Specification", Khronos Group, 2021, and the KHR
// extension texts it links to.
#pragma once

#include <cstdint>
#include <filesystem>

#include "weft/limits.h"
#include "weft/result.h"
#include "weft/scene/load_progress.h"
#include "weft/scene/scene.h"

namespace weft::scene {

using weft::SceneLimits;

// `file_or_folder`: a .gltf, a .glb, or a folder that holds exactly one of them.
[[nodiscard]] Result<Scene> load_gltf(const std::filesystem::path& file_or_folder, Diagnostics& warnings,
                                      const SceneLimits& limits = {}, const LoadOptions& options = {});

}  // namespace weft::scene

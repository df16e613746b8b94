// Purpose: a glTF 2.0 file as a Scene. The file is treated as hostile: nothing outside its folder is opened,
// no count in it is believed before it was compared with the bytes that are there, and every total has a
// limit. Units: as in scene.h; glTF's own (metres, radians, candela, lux) are the same. emissiveFactor times
// emissiveStrength is read as cd/m².
// Errors: S101…S149, each with the file and a JSON pointer. Warnings: S150…S199, for what was left out or
// mended. Source: "glTF 2.0 Specification", Khronos Group, 2021, and the KHR extension texts it links to.
#pragma once

#include <cstdint>
#include <filesystem>

#include "scene/load_progress.h"
#include "scene/scene.h"
#include "weft/result.h"

namespace weft::scene {

struct SceneLimits {
    uint64_t json_bytes = 256ull << 20;
    uint64_t json_values = 2'000'000;
    uint32_t json_depth = 64;
    uint64_t resource_bytes = 1ull << 30;  // buffers and encoded images together
    uint32_t array_items = 262'144;        // nodes, accessors, buffer views, meshes…
    uint32_t materials = 16'384;           // also textures and images
    uint32_t node_depth = 512;
    uint32_t instances = 1'000'000;
    uint64_t vertices = 16'000'000;
    uint64_t triangles = 16'000'000;
    uint32_t image_side_px = 16'384;
    uint64_t decoded_image_bytes = 512ull << 20;  // mip 0 of every texture together
};

// `file_or_folder`: a .gltf, a .glb, or a folder that holds exactly one of them.
[[nodiscard]] Result<Scene> load_gltf(const std::filesystem::path& file_or_folder, Diagnostics& warnings,
                                      const SceneLimits& limits = {}, const LoadOptions& options = {});

}  // namespace weft::scene

// Purpose: loads the bytes of a glTF's buffers and images. They come from data: URIs, from the binary chunk
// of the .glb, or from files below the scene's folder. No other code turns a URI of a glTF into a path of the
// file system. Errors: S101 missing file, S102 broken data: URI, S103 URI that leaves the folder, S104 fewer
// bytes than byteLength, S107 more bytes than the limits.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scene/gltf/gltf_check.h"
#include "scene/gltf/gltf_document.h"
#include "scene/loading/gltf_report.h"
#include "scene/loading/memory_budget.h"
#include "scene/loading/rooted_folder.h"

namespace weft::scene::gltf {

struct Resources {
    // The bytes of each buffer. Each vector has exactly the length byteLength from the JSON.
    std::vector<std::vector<uint8_t>> buffers;
    std::vector<EncodedImage> images;
};

// Loads all buffers and images. Returns nullopt after errors were reported.
[[nodiscard]] std::optional<Resources> load_resources(CheckedJson& checked,
                                                      std::optional<std::span<const uint8_t>> binary,
                                                      const RootedFolder& folder, const SceneLimits& limits,
                                                      MemoryBudget& memory, Report& report);

}  // namespace weft::scene::gltf

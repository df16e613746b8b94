// Purpose: converts the checked JSON and the loaded bytes to a Document with tinygltf. tinygltf gets a
// callback that returns the loaded buffers by number. So tinygltf never opens a file, and it is built without
// code that could do so.
#pragma once

#include <optional>

#include "scene/gltf/gltf_document.h"
#include "scene/gltf/gltf_resources.h"

namespace weft::scene::gltf {

// Converts the checked JSON to a Document. Returns nullopt after errors were reported.
[[nodiscard]] std::optional<Document> parse_document(const CheckedJson& checked, Resources resources,
                                                     Report& report);

}  // namespace weft::scene::gltf

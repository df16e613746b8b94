// Purpose: converts the checked JSON (the text of the file after all checks) and the loaded bytes to a
// Document with tinygltf. A callback gives tinygltf the loaded buffers by number. So tinygltf never opens a
// file, and it is built without the code that opens files.
#pragma once

#include <optional>

#include "scene/gltf/gltf_document.h"
#include "scene/gltf/gltf_resources.h"

namespace weft::scene::gltf {

// Converts the checked JSON to a Document. Returns nullopt after errors were reported.
[[nodiscard]] std::optional<Document> parse_document(const CheckedJson& checked, Resources resources,
                                                     Report& report);

}  // namespace weft::scene::gltf

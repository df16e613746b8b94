// Purpose: converts checked JSON and loaded bytes to a Document with tinygltf. tinygltf gets a file callback
// that returns the loaded buffers by number: it never opens a file, and is built without code that could.
#pragma once

#include <optional>

#include "scene/gltf/gltf_document.h"
#include "scene/gltf/gltf_resources.h"

namespace weft::scene::gltf {

// nullopt after errors were reported.
[[nodiscard]] std::optional<Document> parse_document(const CheckedJson& checked, Resources resources,
                                                     Report& report);

}  // namespace weft::scene::gltf

// Purpose: decodes the images that materials and lights use, once each, and makes one texture for every
// meaning they are used with: an image that is both colour and data becomes an sRGB and a linear texture.
// Errors: S106 an image over the limits or the memory that is left, S112 an image that cannot be decoded.
#pragma once

#include <vector>

#include "scene/gltf/gltf_document.h"
#include "scene/loading/gltf_report.h"
#include "scene/loading/memory_budget.h"
#include "weft/scene/load_gltf.h"

namespace weft::scene::gltf {

// The images are decoded side by side; the result does not depend on how many threads there are. Returns the
// textures and points the slots of `materials`, and the pictures of `functions`, from glTF textures to them.
// A slot whose texture has no image becomes empty.
[[nodiscard]] std::vector<Texture> build_textures(const Document& document, const SceneLimits& limits,
                                                  const LoadOptions& options, MemoryBudget& memory,
                                                  Report& report, std::vector<Material>& materials,
                                                  std::vector<LightFunction>& functions);

}  // namespace weft::scene::gltf

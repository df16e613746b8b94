// Purpose: decodes each image that materials and lights use, once per image, and makes one texture for each
// kind of use. For example, an image that is used as colour and as data becomes an sRGB texture and a linear
// texture. Errors: S106 an image over the limits or the remaining memory, S112 an image that cannot be
// decoded, X571 memory ran out.
#pragma once

#include <vector>

#include "scene/gltf/gltf_document.h"
#include "scene/loading/gltf_report.h"
#include "scene/loading/memory_budget.h"
#include "weft/scene/load_gltf.h"

namespace weft::scene::gltf {

// Decodes the images in parallel; the result does not depend on the number of threads. Returns the textures.
// The texture indices in `materials` and `functions` are changed from indices of glTF textures to indices of
// the returned textures. If a glTF texture has no image, the members that refer to it become kNone.
[[nodiscard]] std::vector<Texture> build_textures(const Document& document, const SceneLimits& limits,
                                                  const LoadOptions& options, MemoryBudget& memory,
                                                  Report& report, std::vector<Material>& materials,
                                                  std::vector<LightFunction>& functions);

}  // namespace weft::scene::gltf

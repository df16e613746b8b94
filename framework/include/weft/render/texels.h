// Purpose: the numbers behind texels that were read back: each as four floats, missing channels 0 and
// alpha 1. sRGB is decoded, normalised integers become [0, 1] or [-1, 1], plain integers keep their value.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "weft/format.h"

namespace weft::render {

// `bytes` holds tightly packed texels; what does not fill a whole one is ignored. Depth-stencil gives depth.
[[nodiscard]] std::vector<glm::vec4> decode_texels(Format format, std::span<const std::byte> bytes);

}  // namespace weft::render

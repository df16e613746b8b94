// Purpose: converts each texel that was read back from the GPU to four floats. Missing channels become 0, a
// missing alpha becomes 1. sRGB is decoded, normalised integers become [0, 1] or [-1, 1], other integers keep
// their value.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "weft/format.h"

namespace weft::render {

// Converts `bytes`, which are texels without padding. An incomplete last texel is ignored. For depth-stencil
// formats, the result is the depth.
[[nodiscard]] std::vector<glm::vec4> decode_texels(Format format, std::span<const std::byte> bytes);

}  // namespace weft::render

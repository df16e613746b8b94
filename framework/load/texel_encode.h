// Purpose: converts the texels of a picture to the format of an image, and makes its mips with a box filter.
// Source: the formats of Vulkan 1.3; IEC 61966-2-1 (sRGB).
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "weft/format.h"

namespace weft {

// Converts values to texels of a colour format. unorm: values are clamped to [0, 1] and rounded; snorm:
// clamped to [-1, 1]; integers: values are multiplied by `whole` (if it is not 0), rounded and clamped to the
// range of the format. sRGB: the values are stored as they are if `is_encoded` is true, otherwise encoded.
struct TexelSource {
    float whole = 0;
    bool is_encoded = false;
};
[[nodiscard]] std::vector<std::byte> encode_texels(Format format, std::span<const glm::vec4> values,
                                                   const TexelSource& source);

// Returns the next smaller mip. Each texel is the mean of the texels that it covers, weighted by area. Sizes
// are in texels.
[[nodiscard]] std::vector<glm::vec4> halve(std::span<const glm::vec4> values, uint32_t width,
                                           uint32_t height);

}  // namespace weft

// Purpose: encodes pictures as the bytes of a file. PNG is display-encoded (sRGB, 8 bits); EXR (32-bit float)
// and PFM contain raw values. Shapes: width × height RGBA texels, row 0 on top; PFM stores rows from bottom
// to top, as its format requires, and has no alpha. Errors: X510 without a file: there is no memory for the
// bytes.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>

#include "weft/result.h"

namespace weft::viewer {

[[nodiscard]] Result<std::string> encode_png(uint32_t width_px, uint32_t height_px,
                                             std::span<const std::byte> rgba8);
[[nodiscard]] Result<std::string> encode_exr(uint32_t width_px, uint32_t height_px,
                                             std::span<const glm::vec4> texels);
[[nodiscard]] Result<std::string> encode_pfm(uint32_t width_px, uint32_t height_px,
                                             std::span<const glm::vec4> texels);

}  // namespace weft::viewer

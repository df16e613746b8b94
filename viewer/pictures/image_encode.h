// Purpose: encodes pictures as the bytes of an EXR (32-bit float) or PFM file, which contain raw values. The
// input has width × height RGBA texels, with row 0 at the top. A PFM file has no alpha, and stores its rows
// from bottom to top. Error X510: the library cannot encode the picture, for example because memory runs out.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>

#include "weft/result.h"

namespace weft::viewer {

[[nodiscard]] Result<std::string> encode_exr(uint32_t width_px, uint32_t height_px,
                                             std::span<const glm::vec4> texels);
[[nodiscard]] Result<std::string> encode_pfm(uint32_t width_px, uint32_t height_px,
                                             std::span<const glm::vec4> texels);

}  // namespace weft::viewer

// Purpose: encodes a picture as the bytes of a PNG file. The texels are RGBA with 8 bits per channel, encoded
// as sRGB, with row 0 at the top. Error X510: libpng cannot encode the picture, for example because memory
// runs out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "weft/result.h"

namespace weft::scene {

[[nodiscard]] Result<std::string> encode_png(uint32_t width_px, uint32_t height_px,
                                             std::span<const std::byte> rgba8);

}  // namespace weft::scene

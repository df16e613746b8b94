// Purpose: PNG to 8-bit RGBA with libpng, row by row into the result. Every kind of PNG is read: palettes,
// transparency by colour, 1 to 16 bits a channel (the high byte is kept), interlaced ones. Chunks that say
// how colours are meant (gAMA, iCCP) are passed over, as glTF asks, and so are texts. Errors: as
// image_decode.h says.
#pragma once

#include "weft/scene/image_decode.h"

namespace weft::scene {

[[nodiscard]] bool is_png(std::span<const uint8_t> encoded);
[[nodiscard]] std::optional<ImageSize> read_png_size(std::span<const uint8_t> encoded);
[[nodiscard]] DecodedImage decode_png(std::span<const uint8_t> encoded);

}  // namespace weft::scene

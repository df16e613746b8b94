// Purpose: decodes JPEG to 8-bit RGBA with libjpeg-turbo: baseline and progressive, grey, YCbCr, RGB, CMYK
// and YCCK. The limit on the decoder's memory is computed from the picture's size in the file's header. A
// file may have at most 100 scans.
// Errors: see image_decode.h.
#pragma once

#include "weft/scene/image_decode.h"

namespace weft::scene {

[[nodiscard]] std::optional<ImageSize> read_jpeg_size(std::span<const uint8_t> encoded);
[[nodiscard]] DecodedImage decode_jpeg(std::span<const uint8_t> encoded);

}  // namespace weft::scene

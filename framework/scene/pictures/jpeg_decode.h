// Purpose: decodes JPEG to 8-bit RGBA with libjpeg-turbo: baseline and progressive, grey, YCbCr, RGB, CMYK
// and YCCK. The limit on memory follows from the file's header, and a file may have at most 100 scans.
// Errors: see image_decode.h.
#pragma once

#include "weft/scene/image_decode.h"

namespace weft::scene {

[[nodiscard]] std::optional<ImageSize> read_jpeg_size(std::span<const uint8_t> encoded);
[[nodiscard]] DecodedImage decode_jpeg(std::span<const uint8_t> encoded);

}  // namespace weft::scene

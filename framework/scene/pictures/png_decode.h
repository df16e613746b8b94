// Purpose: decodes PNG to 8-bit RGBA with libpng, row by row into the result. All kinds of PNG are supported:
// palettes, colour-key transparency, 1 to 16 bits per channel (only the high byte is used), interlaced
// pictures. Colour profiles (gAMA, iCCP) are ignored, as glTF requires, and so are text chunks. Errors: see
// image_decode.h.
#pragma once

#include "weft/scene/image_decode.h"

namespace weft::scene {

[[nodiscard]] bool is_png(std::span<const uint8_t> encoded);
[[nodiscard]] std::optional<ImageSize> read_png_size(std::span<const uint8_t> encoded);
[[nodiscard]] DecodedImage decode_png(std::span<const uint8_t> encoded);

// A picture with four channels of 16 bits.
struct DecodedPng16 {
    ImageSize size;
    std::vector<uint16_t> rgba;
    std::string error;
};
// Returns true if the channels of the picture have 16 bits.
[[nodiscard]] bool is_png_16(std::span<const uint8_t> encoded);
// Decodes a picture without loss. is_png_16() must be true for the picture.
[[nodiscard]] DecodedPng16 decode_png_16(std::span<const uint8_t> encoded);

}  // namespace weft::scene

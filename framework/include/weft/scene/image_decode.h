// Purpose: PNG and JPEG to 8-bit RGBA. The header tells the size before a pixel is decoded, and the decoder
// allocates no more than that size justifies: data beyond the last row is never inflated. Source: libpng and
// libjpeg-turbo decode. Errors: `error` says what was found; the image is empty then.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace weft::scene {

struct ImageSize {
    uint32_t width_px = 0;
    uint32_t height_px = 0;
    // The memory that the decoder allocates in addition to the result, which has four bytes a pixel.
    uint64_t decoder_bytes = 0;

    [[nodiscard]] uint64_t texels() const { return uint64_t{width_px} * height_px; }
};

// nullopt when it is neither PNG nor JPEG, or the header is cut short or invalid.
[[nodiscard]] std::optional<ImageSize> read_image_size(std::span<const uint8_t> encoded);

struct DecodedImage {
    ImageSize size;
    std::vector<uint8_t> rgba;
    std::string error;
};
[[nodiscard]] DecodedImage decode_image(std::span<const uint8_t> encoded);

}  // namespace weft::scene

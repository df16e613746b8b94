// Purpose: decodes PNG and JPEG to 8-bit RGBA. The size is read from the header before any pixel is decoded.
// The decoder allocates no more memory than a picture of this size needs. A PNG file is refused if it has
// much more data than a picture of this size can need. Source: libpng and libjpeg-turbo. Errors:
// DecodedImage::error has the reason, and `rgba` is empty.
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
    // Memory that the decoder allocates in addition to the decoded image. The image itself needs four bytes
    // per pixel.
    uint64_t decoder_bytes = 0;

    [[nodiscard]] uint64_t texels() const { return uint64_t{width_px} * height_px; }
};

// Reads the size from the header. Returns nullopt if the data is neither PNG nor JPEG, or if the header is
// incomplete or invalid.
[[nodiscard]] std::optional<ImageSize> read_image_size(std::span<const uint8_t> encoded);

struct DecodedImage {
    ImageSize size;
    std::vector<uint8_t> rgba;
    std::string error;
};
[[nodiscard]] DecodedImage decode_image(std::span<const uint8_t> encoded);

}  // namespace weft::scene

// Purpose: PNG and JPEG to 8-bit RGBA, the size known before a pixel is decoded. No single allocation of the
// decoder exceeds kMaxDecoderAllocationBytes, so a small header before a large compressed stream stays small.
// Errors: `error` says what was found; the image is empty then.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace weft::scene {

inline constexpr size_t kMaxDecoderAllocationBytes = 576ull << 20;

struct ImageSize {
    uint32_t width_px = 0;
    uint32_t height_px = 0;
};

// nullopt when it is neither PNG nor JPEG, or the header is cut short or can't be.
[[nodiscard]] std::optional<ImageSize> read_image_size(std::span<const uint8_t> encoded);

struct DecodedImage {
    ImageSize size;
    std::vector<uint8_t> rgba;
    std::string error;
};
[[nodiscard]] DecodedImage decode_image(std::span<const uint8_t> encoded);

}  // namespace weft::scene

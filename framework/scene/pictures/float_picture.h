// Purpose: pictures with floating-point values: EXR (one part; channels R, G, B and A, or a single channel)
// and PFM (colour or grey). Shapes: row 0 is the top row. A missing alpha is 1. Errors: `error` has the
// reason, and there are no texels. Check the size of a header before decoding: it can contain any number.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace weft::scene {

struct FloatPictureHeader {
    int64_t width_px = 0, height_px = 0;   // As in the file; may be 0 or negative.
    uint64_t decoder_bytes_per_texel = 0;  // Memory that the decoder needs besides the texels.
    std::string error;
};

struct FloatPicture {
    uint32_t width_px = 0, height_px = 0;
    std::vector<glm::vec4> texels;
    std::string error;
};

[[nodiscard]] FloatPictureHeader read_exr_header(std::span<const uint8_t> encoded);
[[nodiscard]] FloatPicture decode_exr(std::span<const uint8_t> encoded);
[[nodiscard]] FloatPictureHeader read_pfm_header(std::span<const uint8_t> encoded);
// The size in the header must be at least 1 × 1.
[[nodiscard]] FloatPicture decode_pfm(std::span<const uint8_t> encoded);

}  // namespace weft::scene

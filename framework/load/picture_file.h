// Purpose: reads pictures of all kinds that a resource may have: PNG (8 and 16 bits), JPEG, Radiance HDR, EXR
// and PFM. The first bytes of the file determine the kind, not its name. Shapes: row 0 is the top row.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace weft {

// Memory in bytes for one pixel while a picture is converted.
inline constexpr uint64_t kBytesPerPixel = 16;

struct PictureHeader {
    // 0 if the file is no picture; then its bytes are texels.
    uint32_t width_px = 0, height_px = 0;
    uint64_t decoder_bytes = 0;  // Memory that the decoder needs besides kBytesPerPixel.
    std::string fault;           // Not empty: the file is a picture, but its header is damaged.
};
// Returns the memory that decode_picture() needs.
[[nodiscard]] inline uint64_t decoding_bytes(const PictureHeader& header) {
    return header.decoder_bytes + uint64_t{header.width_px} * header.height_px * kBytesPerPixel;
}
// `bytes` are the first bytes of the file, or all of them.
[[nodiscard]] PictureHeader read_picture_header(std::string_view bytes);

struct PictureTexels {
    uint32_t width_px = 0, height_px = 0;
    // Values of all pixels. Whole numbers are divided by `whole`; values of files with floats are unchanged.
    std::vector<glm::vec4> values;
    float whole = 0;    // The largest stored whole number: 255 or 65535. 0: the file has floats.
    std::string fault;  // Not empty: the picture cannot be decoded.
};
[[nodiscard]] PictureTexels decode_picture(std::string_view bytes);

}  // namespace weft

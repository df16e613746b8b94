// Purpose: decodes Radiance pictures ("#?RADIANCE", 32-bit_rle_rgbe) to linear RGB; rows may be uncompressed
// or run-length encoded. The library stb also reads this format, but its decoder does not return when a file
// ends early. Shapes: row 0 is the top row. Only the orientation "-Y height +X width" is accepted, which is
// the usual one. Texels are divided by the factors of the EXPOSURE lines in the header. Errors: `error`
// contains the reason, and there are no texels. The format cannot store NaN or infinity. Source: G. Ward,
// "Real Pixels", in "Graphics Gems II", 1991.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace weft::scene {

struct RadianceHeader {
    uint32_t width_px = 0;
    uint32_t height_px = 0;
    float exposure = 1;
    size_t data_begin = 0;  // Offset of the first texel's data from the beginning of the file, in bytes.
    std::string error;
};
[[nodiscard]] RadianceHeader read_radiance_header(std::span<const uint8_t> encoded);

struct RadiancePicture {
    std::vector<glm::vec3> texels;
    std::string error;
};
[[nodiscard]] RadiancePicture decode_radiance(const RadianceHeader& header, std::span<const uint8_t> encoded);

}  // namespace weft::scene

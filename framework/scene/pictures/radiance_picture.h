// Purpose: Radiance pictures ("#?RADIANCE", 32-bit_rle_rgbe), flat or run-length encoded, to linear RGB. stb
// reads them too, but where a file ends early its decoder never does.
// Shapes: row 0 on top; only "-Y height +X width", which is what programs write. What EXPOSURE lines of the
// header say has been multiplied in is divided out.
// Errors: `error` says what was found; there are no texels then. NaN and infinity don't exist in this format.
// Source: G. Ward, "Real Pixels", in "Graphics Gems II", 1991.
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
    size_t data_begin = 0;  // in bytes
    std::string error;
};
[[nodiscard]] RadianceHeader read_radiance_header(std::span<const uint8_t> encoded);

struct RadiancePicture {
    std::vector<glm::vec3> texels;
    std::string error;
};
[[nodiscard]] RadiancePicture decode_radiance(const RadianceHeader& header, std::span<const uint8_t> encoded);

}  // namespace weft::scene

// Purpose: decodes Radiance pictures ("#?RADIANCE", 32-bit_rle_rgbe), flat or run-length encoded, to linear
// RGB. stb also reads this format, but does not return when a file ends early. Shapes: row 0 on top; only "-Y
// height +X width", which is the form that programs write. Texels are divided by the factor that EXPOSURE
// lines of the header give. Errors: `error` has the reason, and there are no texels. The format cannot hold
// NaN or infinity. Source: G. Ward, "Real Pixels", in "Graphics Gems II", 1991.
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
    size_t data_begin = 0;  // offset in bytes
    std::string error;
};
[[nodiscard]] RadianceHeader read_radiance_header(std::span<const uint8_t> encoded);

struct RadiancePicture {
    std::vector<glm::vec3> texels;
    std::string error;
};
[[nodiscard]] RadiancePicture decode_radiance(const RadianceHeader& header, std::span<const uint8_t> encoded);

}  // namespace weft::scene

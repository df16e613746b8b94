// Makes picture files for tests, without the code of `weft` that writes pictures.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace weft::test {

using Texel = std::array<float, 3>;

// Returns a PFM file with these values, unchanged. Row 0 of `texels` is the top row.
[[nodiscard]] std::string pfm_file(uint32_t width_px, uint32_t height_px, std::span<const Texel> texels,
                                   bool big_endian = false);
// Returns an OpenEXR file with uncompressed scan lines of 32-bit floats.
[[nodiscard]] std::string exr_file(uint32_t width_px, uint32_t height_px, std::span<const Texel> texels);
// Returns an opaque PNG file with 8 bits per channel. The values of `texels` are 0 to 255.
[[nodiscard]] std::string png_file(uint32_t width_px, uint32_t height_px, std::span<const Texel> texels);

}  // namespace weft::test

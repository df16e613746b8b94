// Writes picture files without the program's own writers.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace weft::test {

using Texel = std::array<float, 3>;

// Row 0 on top. Values are stored unchanged.
[[nodiscard]] std::string pfm_file(uint32_t width_px, uint32_t height_px, std::span<const Texel> texels,
                                   bool big_endian = false);
// Uncompressed scan lines of 32-bit floats.
[[nodiscard]] std::string exr_file(uint32_t width_px, uint32_t height_px, std::span<const Texel> texels);
// 8-bit values, 0 to 255, opaque.
[[nodiscard]] std::string png_file(uint32_t width_px, uint32_t height_px, std::span<const Texel> texels);

}  // namespace weft::test

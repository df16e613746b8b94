// Reads the raw pictures that `weft render -o x.pfm` writes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace weft::test {

struct PfmImage {
    uint32_t width_px = 0;
    uint32_t height_px = 0;
    // Pixels row by row; row 0 is the top row.
    std::vector<std::array<float, 3>> texels;

    [[nodiscard]] const std::array<float, 3>& at(uint32_t x, uint32_t y) const {
        return texels[size_t{y} * width_px + x];
    }
};

// Reads a PFM file with little-endian numbers and three channels, and with at most 16384 texels per side.
// Returns nullopt for any other file.
[[nodiscard]] std::optional<PfmImage> read_pfm(const std::string& path);

}  // namespace weft::test

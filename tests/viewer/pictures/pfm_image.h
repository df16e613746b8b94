// Raw pictures written by `weft render -o x.pfm`.
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
    std::vector<std::array<float, 3>> texels;  // row 0 on top

    [[nodiscard]] const std::array<float, 3>& at(uint32_t x, uint32_t y) const {
        return texels[size_t{y} * width_px + x];
    }
};

// Reads little-endian files with three channels; nullopt for other files.
[[nodiscard]] std::optional<PfmImage> read_pfm(const std::string& path);

}  // namespace weft::test

// A second implementation of FLIP, for comparison: in double precision, every filter as one sum over a square
// of texels, and the colour matrix computed from the primaries. Shares no code with framework/image.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace weft::image::test {

using Rgb = std::array<double, 3>;  // display-encoded, 0 to 1

struct DirectImage {
    int width_px = 0, height_px = 0;
    std::vector<Rgb> texels;
};

[[nodiscard]] std::vector<double> flip_direct(const DirectImage& reference, const DirectImage& test,
                                              double pixels_per_degree);

// The FLIP value of two constant pictures: filters do not change them and they have no features.
[[nodiscard]] double flip_of_constants(const Rgb& reference, const Rgb& test);

}  // namespace weft::image::test

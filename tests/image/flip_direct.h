// Purpose: a second implementation of the FLIP metric, to check the one in framework/image. The two share no
// code. This one uses double precision, computes every filter as one sum over a square of texels, and
// computes the colour matrix from the primaries.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace weft::image::test {

// Three colour channels. In this header they are display-encoded, each from 0 to 1.
using Rgb = std::array<double, 3>;

struct DirectImage {
    int width_px = 0, height_px = 0;
    std::vector<Rgb> texels;
};

// Returns the FLIP error of each texel, row by row, from 0 to 1. The pictures must have the same size.
[[nodiscard]] std::vector<double> flip_direct(const DirectImage& reference, const DirectImage& test,
                                              double pixels_per_degree);

// Returns the FLIP value of two constant pictures. Filters do not change constant pictures, and such pictures
// have no features (edges or points).
[[nodiscard]] double flip_of_constants(const Rgb& reference, const Rgb& test);

}  // namespace weft::image::test

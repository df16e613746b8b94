// Purpose: FLIP's kernels; each is a product of two one-dimensional kernels. Shapes: odd numbers of taps.
// Units: pixels per degree. Source: the paper cited in flip.h, on spatial filtering and feature detection;
// the contrast sensitivities are sums of Gaussians as in G. Johnson and M. Fairchild, "A Top Down Description
// of S-CIELAB and CIEDE2000", 2003.
#pragma once

#include <array>
#include <vector>

namespace weft::image {

struct WeightedGaussian {
    float weight = 0;
    std::vector<float> taps;  // their sum is 1
};

// Kernels for Y, Cx and Cz. The weights of a channel add up to 1, so that a constant picture does not change.
using SensitivityKernels = std::array<std::vector<WeightedGaussian>, 3>;
[[nodiscard]] SensitivityKernels sensitivity_kernels(float pixels_per_degree);

// A detector along x applies `edge` or `point` along x and `smooth` along y. In `edge` and `point` the
// positive taps add up to 1 and the negative ones to -1.
struct FeatureKernels {
    std::vector<float> smooth, edge, point;
};
[[nodiscard]] FeatureKernels feature_kernels(float pixels_per_degree);

}  // namespace weft::image

// Purpose: the filter kernels of FLIP. Each two-dimensional kernel is a product of two one-dimensional
// kernels. Shapes: kernels have odd numbers of taps. Units: the resolution of a picture is in pixels per
// degree of the field of view. Source: the paper cited in flip.h, sections on spatial filtering and feature
// detection. The contrast sensitivities are sums of Gaussians as in G. Johnson and M. Fairchild, "A Top Down
// Description of S-CIELAB and CIEDE2000", 2003.
#pragma once

#include <array>
#include <vector>

namespace weft::image {

struct WeightedGaussian {
    float weight = 0;
    std::vector<float> taps;  // One-dimensional kernel; the sum of the taps is 1.
};

// Blur kernels for the channels Y, Cx and Cz. Each channel is blurred with a weighted sum of Gaussians. The
// weights of a channel add up to 1, so that a picture of one colour does not change.
using SensitivityKernels = std::array<std::vector<WeightedGaussian>, 3>;
[[nodiscard]] SensitivityKernels sensitivity_kernels(float pixels_per_degree);

// Kernels that detect edges and points. A detector along x applies `edge` or `point` along x, and `smooth`
// along y. In `edge` and `point`, the positive taps add up to 1 and the negative taps to -1.
struct FeatureKernels {
    std::vector<float> smooth, edge, point;
};
[[nodiscard]] FeatureKernels feature_kernels(float pixels_per_degree);

}  // namespace weft::image

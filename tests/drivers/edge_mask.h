// Purpose: measures the difference of two drivers' pictures of the same view, separately near edges and
// elsewhere. At the edge of a triangle, one driver may cover a texel that another driver does not cover. That
// texel then has the value of a neighbour. Elsewhere only rounding may differ. Shapes: two display pictures
// of the same size. Units: a step is 1/255 of a channel.
#pragma once

#include <string>

#include "weft/image/image.h"

namespace weft::test {

// Largest difference, in steps of 1/255, that rounding may cause. Texture filters and sRGB decoding round
// too, and their precision depends on the driver.
inline constexpr float kSameSteps = 2;

struct DriverDifference {
    // The largest difference of texels that are not near an edge, in steps of 1/255. A texel is near an edge
    // if the 5×5 texels around it differ by more than twice kSameSteps in a channel of either picture.
    float off_edges_steps = 0;
    // The fraction of the test picture's texels that are outside the range of the 3×3 texels around the same
    // place in the reference picture, by more than kSameSteps in a channel.
    double edge_share = 0;
    double mean_flip = 0;
};

// Largest allowed values of edge_share and mean_flip, for drivers that draw the same triangles.
inline constexpr double kMostEdgeShare = 0.001;
inline constexpr double kMostMeanFlip = 0.005;

[[nodiscard]] bool is_same_off_edges(const DriverDifference& difference);
[[nodiscard]] bool is_within_bounds(const DriverDifference& difference);

[[nodiscard]] DriverDifference compare_drivers(const image::Image& reference, const image::Image& test);

[[nodiscard]] std::string to_text(const DriverDifference& difference);

}  // namespace weft::test

// Purpose: measures the difference of two drivers' pictures of one view, separately near edges and elsewhere.
// At the edge of a triangle one driver may cover a texel that another does not; that texel then has the value
// of a neighbour. Elsewhere only rounding may differ. Shapes: two display pictures of one size. Units: steps
// are 1/255 of a channel.
#pragma once

#include <string>

#include "weft/image/image.h"

namespace weft::test {

// Allows for rounding, including that of texture filters and sRGB decoding, whose precision depends on the
// driver.
inline constexpr float kSameSteps = 2;

struct DriverDifference {
    // The largest difference that is not near an edge. Near an edge means: the 5×5 texels around the texel
    // differ by more than twice kSameSteps in a channel of either picture.
    float off_edges_steps = 0;
    // The fraction of texels that differ by more than kSameSteps from all of the reference's 3×3 texels
    // around them.
    double edge_share = 0;
    double mean_flip = 0;
};

// The limit for drivers that draw the same triangles.
inline constexpr double kMostEdgeShare = 0.001;
inline constexpr double kMostMeanFlip = 0.005;

[[nodiscard]] bool is_same_off_edges(const DriverDifference& difference);
[[nodiscard]] bool is_within_bounds(const DriverDifference& difference);

[[nodiscard]] DriverDifference compare_drivers(const image::Image& reference, const image::Image& test);

[[nodiscard]] std::string to_text(const DriverDifference& difference);

}  // namespace weft::test

// Purpose: how far two drivers' pictures of one view differ, where edges are apart from the rest. Drivers may
// cover a texel at the edge of a triangle or not, and then it shows what a texel beside it shows; elsewhere
// only rounding differs. Shapes: two display pictures of one size. Units: steps are 1/255 of a channel.
#pragma once

#include <string>

#include "weft/image/image.h"

namespace weft::test {

// Rounding, also that of texture filters and of sRGB decoding, whose precision Vulkan leaves to the driver.
inline constexpr float kSameSteps = 2;

struct DriverDifference {
    // The largest difference off the edges. Near an edge: the 5×5 texels around span more than twice
    // kSameSteps in a channel of either picture.
    float off_edges_steps = 0;
    // The share of texels that show what none of the reference's 3×3 texels around shows, by more than
    // kSameSteps.
    double edge_share = 0;
    double mean_flip = 0;
};

// What drivers that draw the same triangles may differ by.
inline constexpr double kMostEdgeShare = 0.001;
inline constexpr double kMostMeanFlip = 0.005;

[[nodiscard]] bool is_same_off_edges(const DriverDifference& difference);
[[nodiscard]] bool is_within_bounds(const DriverDifference& difference);

[[nodiscard]] DriverDifference compare_drivers(const image::Image& reference, const image::Image& test);

[[nodiscard]] std::string to_text(const DriverDifference& difference);

}  // namespace weft::test

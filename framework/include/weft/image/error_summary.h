// Purpose: summarises an error map in a few numbers. Units: those of the map. Quantiles are values that occur
// in the map. Weighted quantiles weight every error by its own size, so that a large black area does not hide
// visible errors: errors up to the q-quantile make up a share q of the total error; 0 for a map without
// errors. Source: the paper cited in flip.h, on pooling.
#pragma once

#include <array>

#include "weft/image/image.h"

namespace weft::image {

struct ErrorSummary {
    double mean = 0, median = 0, max = 0;
    std::array<double, 3> weighted_quartiles{};
};

// The map must not be empty or contain NaN.
[[nodiscard]] ErrorSummary summarize(const Plane& map);

}  // namespace weft::image

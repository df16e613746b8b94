// Purpose: summarises an error map in a few numbers. Units: those of the map. A quantile is always a value
// that occurs in the map. Weighted quantiles give every error a weight of its own size, so that a large area
// without errors does not hide visible errors: all errors up to the weighted q-quantile make up the share q
// of the sum of errors. It is 0 for a map without errors. Source: the paper cited in flip.h, section on
// pooling.
#pragma once

#include <array>

#include "weft/image/image.h"

namespace weft::image {

struct ErrorSummary {
    double mean = 0, median = 0, max = 0;
    std::array<double, 3> weighted_quartiles{};
};

// Computes the summary. The map must not be empty and must not contain NaN.
[[nodiscard]] ErrorSummary summarize(const Plane& map);

}  // namespace weft::image

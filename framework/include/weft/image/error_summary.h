// Purpose: summarises an error map in a few numbers. Units: those of the map. A quantile is always a value
// that occurs in the map. The weighted q-quantile is the smallest error e for which the sum of all errors
// that are at most e is at least q times the sum of all errors. Texels without an error add nothing to these
// sums, so a large area of such texels does not hide visible errors. Weighted quantiles are 0 for a map
// without errors. Source: the paper cited in flip.h, section on pooling.
#pragma once

#include <array>

#include "weft/image/image.h"

namespace weft::image {

struct ErrorSummary {
    double mean = 0, median = 0, max = 0;
    std::array<double, 3> weighted_quartiles{};  // Weighted quantiles for q = 1/4, 1/2 and 3/4.
};

// Computes the summary. The map must not be empty and must not contain NaN.
[[nodiscard]] ErrorSummary summarize(const Plane& map);

}  // namespace weft::image

// Purpose: a map of errors in a few numbers. Units: the map's. Quantiles are values that occur in the map.
// Weighted ones count every error by its own size, so a large black area does not hide what is visible: a
// share q of the whole error comes from errors up to the q-quantile; 0 for a map without errors. Source: the
// paper that flip.h names, on pooling.
#pragma once

#include <array>

#include "weft/image/image.h"

namespace weft::image {

struct ErrorSummary {
    double mean = 0, median = 0, max = 0;
    std::array<double, 3> weighted_quartiles{};
};

// The map is not empty and holds no NaN.
[[nodiscard]] ErrorSummary summarize(const Plane& map);

}  // namespace weft::image

#include "weft/image/error_summary.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace weft::image {

ErrorSummary summarize(const Plane& map) {
    assert(!map.values.empty());
    std::vector<float> sorted = map.values;
    std::sort(sorted.begin(), sorted.end());
    const double sum = std::accumulate(sorted.begin(), sorted.end(), 0.0);
    ErrorSummary summary;
    summary.mean = sum / static_cast<double>(sorted.size());
    summary.median = sorted[(sorted.size() - 1) / 2];
    summary.max = sorted.back();
    if (sum == 0) return summary;
    double so_far = 0;
    size_t quartile = 0;
    for (const float error : sorted) {
        so_far += error;
        while (quartile < 3 && so_far >= 0.25 * static_cast<double>(quartile + 1) * sum)
            summary.weighted_quartiles[quartile++] = error;
    }
    return summary;
}

}  // namespace weft::image

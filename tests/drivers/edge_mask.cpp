#include "tests/drivers/edge_mask.h"

#include <algorithm>
#include <sstream>

#include "weft/image/error_summary.h"
#include "weft/image/flip.h"

namespace weft::test {
namespace {

using image::Image;

// Tolerance for rounding in conversions to and from floats, in steps of 1/255.
constexpr float kRounding = 0.01f;

struct Range {
    glm::vec3 least{1e9f}, most{-1e9f};
};

// Returns the range of the texels around (x, y) whose distance is at most `radius` texels in x and y. The
// range is in steps of 1/255.
Range range_around(const Image& picture, int x, int y, int radius) {
    const int width = static_cast<int>(picture.width_px), height = static_cast<int>(picture.height_px);
    Range range;
    for (int row = std::max(y - radius, 0); row <= std::min(y + radius, height - 1); ++row)
        for (int column = std::max(x - radius, 0); column <= std::min(x + radius, width - 1); ++column) {
            const glm::vec3 texel = picture.texels[static_cast<size_t>(row * width + column)] * 255.0f;
            range.least = glm::min(range.least, texel);
            range.most = glm::max(range.most, texel);
        }
    return range;
}

float largest(const glm::vec3& v) {
    return std::max({v.x, v.y, v.z});
}

bool near_edge(const Image& picture, int x, int y) {
    const Range range = range_around(picture, x, y, 2);
    return largest(range.most - range.least) > 2 * kSameSteps;
}

}  // namespace

DriverDifference compare_drivers(const Image& reference, const Image& test) {
    DriverDifference difference;
    size_t foreign = 0;
    for (size_t i = 0; i < test.texels.size(); ++i) {
        const int x = static_cast<int>(i % test.width_px), y = static_cast<int>(i / test.width_px);
        const glm::vec3 texel = test.texels[i] * 255.0f;
        const float steps = largest(glm::abs(texel - reference.texels[i] * 255.0f));
        if (!near_edge(reference, x, y) && !near_edge(test, x, y))
            difference.off_edges_steps = std::max(difference.off_edges_steps, steps);
        const Range around = range_around(reference, x, y, 1);
        const float outside = largest(glm::max(around.least - texel, texel - around.most));
        if (outside > kSameSteps + kRounding) ++foreign;
    }
    difference.edge_share = static_cast<double>(foreign) / static_cast<double>(test.texels.size());
    difference.mean_flip = image::summarize(image::flip_map(reference, test)).mean;
    return difference;
}

bool is_same_off_edges(const DriverDifference& difference) {
    return difference.off_edges_steps <= kSameSteps + kRounding;
}

bool is_within_bounds(const DriverDifference& difference) {
    return is_same_off_edges(difference) && difference.edge_share <= kMostEdgeShare &&
           difference.mean_flip <= kMostMeanFlip;
}

std::string to_text(const DriverDifference& difference) {
    std::ostringstream text;
    text << "off edges " << difference.off_edges_steps << "/255, edge texels " << 100 * difference.edge_share
         << " %, mean FLIP " << difference.mean_flip;
    return text.str();
}

}  // namespace weft::test

#include "image/channel_difference.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace weft::image {
namespace {

// Whole numbers from 0 to 255.
Image to_steps(const Image& image) {
    Image steps = to_display(image);
    for (glm::vec3& texel : steps.texels) texel = glm::round(texel * 255.0f);
    return steps;
}

bool compares_raw(const Image& a, const Image& b) {
    return a.encoding == Encoding::linear && b.encoding == Encoding::linear;
}

float difference(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;  // two infinities too
    if (std::isnan(a) || std::isnan(b)) return std::numeric_limits<float>::infinity();
    return std::abs(a - b);
}

// The largest difference of each texel's channels, times `scale`.
Plane largest_of_channels(const Image& a, const Image& b, float scale) {
    Plane map{a.width_px, a.height_px, std::vector<float>(a.texels.size())};
    for (size_t i = 0; i < map.values.size(); ++i) {
        const glm::vec3 &p = a.texels[i], &q = b.texels[i];
        map.values[i] = scale * std::max({difference(p.r, q.r), difference(p.g, q.g), difference(p.b, q.b)});
    }
    return map;
}

}  // namespace

double psnr_db(const Image& a, const Image& b) {
    assert(same_size(a, b) && !a.texels.empty());
    const Image steps_a = to_steps(a), steps_b = to_steps(b);
    double squares = 0;
    for (size_t i = 0; i < steps_a.texels.size(); ++i) {
        const glm::dvec3 d = glm::dvec3(steps_a.texels[i]) - glm::dvec3(steps_b.texels[i]);
        squares += glm::dot(d, d);
    }
    const double mean = squares / (3.0 * static_cast<double>(steps_a.texels.size()));
    if (mean == 0) return std::numeric_limits<double>::infinity();
    return 10 * std::log10(255.0 * 255.0 / mean);
}

double largest_difference(const Image& a, const Image& b) {
    assert(same_size(a, b) && !a.texels.empty());
    const Plane map =
        compares_raw(a, b) ? largest_of_channels(a, b, 1) : largest_of_channels(to_steps(a), to_steps(b), 1);
    return *std::max_element(map.values.begin(), map.values.end());
}

Plane difference_map(const Image& a, const Image& b) {
    assert(same_size(a, b) && !a.texels.empty());
    if (compares_raw(a, b)) return largest_of_channels(a, b, 1);
    return largest_of_channels(to_steps(a), to_steps(b), 1.0f / 255);
}

}  // namespace weft::image

#include "weft/image/channel_difference.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace weft::image {
namespace {

// Returns the channels of a texel as whole numbers from 0 to 255.
glm::vec3 step_texel(const Image& image, size_t index) {
    return glm::round(display_texel(image, index) * 255.0f);
}

bool compares_raw(const Image& a, const Image& b) {
    return a.encoding == Encoding::linear && b.encoding == Encoding::linear;
}

float difference(float a, float b) {
    // `a == b` is also true for two equal infinities. Their difference a - b would be NaN instead of 0.
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    if (std::isnan(a) || std::isnan(b)) return std::numeric_limits<float>::infinity();
    return std::abs(a - b);
}

float largest_of(const glm::vec3& p, const glm::vec3& q) {
    return std::max({difference(p.r, q.r), difference(p.g, q.g), difference(p.b, q.b)});
}

// Returns the largest channel difference between texel `index` of `a` and of `b`. If `raw` is true, this is a
// difference of stored values; else it is a difference of display values, in steps of 1/255.
float difference_at(const Image& a, const Image& b, bool raw, size_t index) {
    return raw ? largest_of(a.texels[index], b.texels[index])
               : largest_of(step_texel(a, index), step_texel(b, index));
}

}  // namespace

double psnr_db(const Image& a, const Image& b) {
    assert(same_size(a, b) && !a.texels.empty());
    double squares = 0;
    for (size_t i = 0; i < a.texels.size(); ++i) {
        const glm::dvec3 d = glm::dvec3(step_texel(a, i)) - glm::dvec3(step_texel(b, i));
        squares += glm::dot(d, d);
    }
    const double mean = squares / (3.0 * static_cast<double>(a.texels.size()));
    if (mean == 0) return std::numeric_limits<double>::infinity();
    return 10 * std::log10(255.0 * 255.0 / mean);
}

double largest_difference(const Image& a, const Image& b) {
    assert(same_size(a, b) && !a.texels.empty());
    const bool raw = compares_raw(a, b);
    float most = 0;
    for (size_t i = 0; i < a.texels.size(); ++i) most = std::max(most, difference_at(a, b, raw, i));
    return most;
}

Plane difference_map(const Image& a, const Image& b, Compared compared) {
    assert(same_size(a, b) && !a.texels.empty());
    const bool raw = compared == Compared::as_they_are && compares_raw(a, b);
    const float scale = raw ? 1 : 1.0f / 255;
    Plane map{a.width_px, a.height_px, std::vector<float>(a.texels.size())};
    for (size_t i = 0; i < map.values.size(); ++i) map.values[i] = scale * difference_at(a, b, raw, i);
    return map;
}

}  // namespace weft::image

#include "image/separable_filter.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace weft::image {
namespace {

// Adds `weight` times `in` to `out`. This is the inner loop of both filters. It has no branches, so that the
// compiler vectorises it.
void add_scaled(float* out, const float* in, float weight, size_t count) {
    for (size_t i = 0; i < count; ++i) out[i] += weight * in[i];
}

Plane zeros_like(const Plane& plane) {
    return {plane.width_px, plane.height_px, std::vector<float>(plane.values.size())};
}

}  // namespace

Plane filter_rows(const Plane& plane, std::span<const float> kernel) {
    assert(kernel.size() % 2 == 1);
    const size_t width = plane.width_px, radius = kernel.size() / 2;
    Plane result = zeros_like(plane);
    std::vector<float> row(width + 2 * radius);
    for (size_t y = 0; y < plane.height_px; ++y) {
        const float* in = plane.values.data() + y * width;
        std::fill_n(row.begin(), radius, in[0]);
        std::copy_n(in, width, row.data() + radius);
        std::fill_n(row.data() + radius + width, radius, in[width - 1]);
        for (size_t tap = 0; tap < kernel.size(); ++tap)
            add_scaled(result.values.data() + y * width, row.data() + tap, kernel[tap], width);
    }
    return result;
}

Plane filter_columns(const Plane& plane, std::span<const float> kernel) {
    assert(kernel.size() % 2 == 1);
    const size_t width = plane.width_px;
    const auto radius = static_cast<ptrdiff_t>(kernel.size() / 2);
    const auto last = static_cast<ptrdiff_t>(plane.height_px) - 1;
    Plane result = zeros_like(plane);
    for (ptrdiff_t y = 0; y <= last; ++y)
        for (ptrdiff_t tap = 0; tap <= 2 * radius; ++tap) {
            const auto from = static_cast<size_t>(std::clamp(y + tap - radius, ptrdiff_t{0}, last));
            add_scaled(result.values.data() + static_cast<size_t>(y) * width,
                       plane.values.data() + from * width, kernel[static_cast<size_t>(tap)], width);
        }
    return result;
}

}  // namespace weft::image

// Purpose: filters a plane along its rows or columns. To apply a two-dimensional filter that is a product of
// two one-dimensional filters, filter the rows and then the columns. Shapes: a kernel has an odd number of
// taps, and the middle tap is on the texel. A texel outside the plane has the value of the nearest texel on
// the border.
#pragma once

#include <span>

#include "weft/image/image.h"

namespace weft::image {

// Filters along x. Each value becomes Σ kernel[i] · value(x + i - radius, y); radius = kernel.size() / 2.
[[nodiscard]] Plane filter_rows(const Plane& plane, std::span<const float> kernel);
// Filters along y, with y = 0 at the top. Each value becomes Σ kernel[i] · value(x, y + i - radius).
[[nodiscard]] Plane filter_columns(const Plane& plane, std::span<const float> kernel);

}  // namespace weft::image

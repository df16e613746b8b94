// Purpose: filters a plane along its rows or columns. A two-dimensional filter that is a product of two
// one-dimensional filters is applied as one after the other. Shapes: a kernel has an odd number of taps, and
// the middle tap is on the texel. A texel outside the plane has the value of the nearest texel on the border.
#pragma once

#include <span>

#include "weft/image/image.h"

namespace weft::image {

// Filters along x. Each value becomes Σ kernel[i] · value(x + i - radius, y).
[[nodiscard]] Plane filter_rows(const Plane& plane, std::span<const float> kernel);
// Filters along y, from top to bottom. Each value becomes Σ kernel[i] · value(x, y + i - radius).
[[nodiscard]] Plane filter_columns(const Plane& plane, std::span<const float> kernel);

}  // namespace weft::image

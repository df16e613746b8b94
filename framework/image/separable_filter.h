// Purpose: filters of two dimensions that are products of two of one. Shapes: a kernel has an odd number of
// taps, its middle one on the texel itself; what lies outside a plane is the nearest texel of its border.
#pragma once

#include <span>

#include "weft/image/image.h"

namespace weft::image {

// Each value becomes Σ kernel[i] · value(x + i - radius, y).
[[nodiscard]] Plane filter_rows(const Plane& plane, std::span<const float> kernel);
// The same from top to bottom.
[[nodiscard]] Plane filter_columns(const Plane& plane, std::span<const float> kernel);

}  // namespace weft::image

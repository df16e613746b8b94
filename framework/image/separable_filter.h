// Purpose: two-dimensional filters that are products of two one-dimensional ones. Shapes: a kernel has an odd
// number of taps, with the middle one on the texel. Texels outside a plane have the value of the nearest
// texel of its border.
#pragma once

#include <span>

#include "weft/image/image.h"

namespace weft::image {

// Each value becomes Σ kernel[i] · value(x + i - radius, y).
[[nodiscard]] Plane filter_rows(const Plane& plane, std::span<const float> kernel);
// The same, from top to bottom.
[[nodiscard]] Plane filter_columns(const Plane& plane, std::span<const float> kernel);

}  // namespace weft::image

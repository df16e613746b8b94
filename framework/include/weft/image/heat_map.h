// Purpose: a map of errors as a picture, from black over purple and orange to light yellow. Shapes: the size
// of the map, 4 bytes a texel (display-encoded RGB, alpha 255). Source: the colour map "magma" by N. Smith
// and S. van der Walt (matplotlib 2.0): its colours at the ninths of its range, interpolated linearly.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "weft/image/image.h"

namespace weft::image {

// Errors are clamped to [0, 1]; NaN is 1.
[[nodiscard]] std::array<std::byte, 4> magma(float error);

[[nodiscard]] std::vector<std::byte> heat_map(const Plane& map);

}  // namespace weft::image

// Purpose: converts an error map to a picture, with colours from black through purple and orange to light
// yellow. Shapes: the picture has the size of the map, and 4 bytes per texel (display-encoded RGB, alpha
// 255). Source: the colour map "magma" by N. Smith and S. van der Walt (matplotlib 2.0), sampled at ten
// points and interpolated linearly between them.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "weft/image/image.h"

namespace weft::image {

// Returns the colour of one error as RGBA. Errors are clamped to [0, 1]; NaN counts as 1.
[[nodiscard]] std::array<std::byte, 4> magma(float error);

[[nodiscard]] std::vector<std::byte> heat_map(const Plane& map);

}  // namespace weft::image

// Pictures for comparisons.
#pragma once

#include <cstdint>

#include "weft/image/image.h"

namespace weft::image::test {

// Channels have 8-bit values.
[[nodiscard]] Image constant(uint32_t width_px, uint32_t height_px, glm::ivec3 rgb);

// Noise of 8-bit values; the same seed gives the same noise on every machine.
[[nodiscard]] Image noise(uint32_t width_px, uint32_t height_px, uint32_t seed);

}  // namespace weft::image::test

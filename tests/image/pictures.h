// Pictures to compare.
#pragma once

#include <cstdint>

#include "weft/image/image.h"

namespace weft::image::test {

// 8-bit values.
[[nodiscard]] Image constant(uint32_t width_px, uint32_t height_px, glm::ivec3 rgb);

// 8-bit noise, the same for the same seed everywhere.
[[nodiscard]] Image noise(uint32_t width_px, uint32_t height_px, uint32_t seed);

}  // namespace weft::image::test

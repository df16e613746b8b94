// Purpose: makes pictures for tests of the image metrics.
#pragma once

#include <cstdint>

#include "weft/image/image.h"

namespace weft::image::test {

// Makes a picture of one colour. The channels of `rgb` are 8-bit values from 0 to 255.
[[nodiscard]] Image constant(uint32_t width_px, uint32_t height_px, glm::ivec3 rgb);

// Makes a picture of random 8-bit values. The same seed gives the same picture on every machine.
[[nodiscard]] Image noise(uint32_t width_px, uint32_t height_px, uint32_t seed);

}  // namespace weft::image::test

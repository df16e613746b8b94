// Purpose: the sub-pixel offset of the camera in each frame (jitter), for graphs that average several frames.
// Units: pixels, x to the right and y down. Source: Halton 1964, "Algorithm 247: Radical-inverse quasi-random
// point sequence"; Karis 2014, "High-Quality Temporal Supersampling".
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace weft::render {

// Writes `index` in base `base` and mirrors its digits at the radix point: 6 = 110 in base 2 becomes 0.011 =
// 0.375. The result is in [0, 1).
[[nodiscard]] double radical_inverse(uint32_t index, uint32_t base);

// Returns the offset of this frame's sample from the pixel's centre. The offsets are points 1 to `length` of
// Halton's sequence in bases 2 and 3, repeated every `length` frames and moved so that their mean is the
// centre. Lengths 0 and 1 give (0, 0).
[[nodiscard]] glm::vec2 jitter_px(uint64_t frame, uint32_t length);

// Returns the number that is added to the mip level of textures. With it, the mean of `length` frames is as
// sharp as a picture with `length` samples in each pixel. The number is at least -2 and at most 0. It is 0
// for the lengths 0 and 1.
[[nodiscard]] float mip_bias(uint32_t length);

}  // namespace weft::render

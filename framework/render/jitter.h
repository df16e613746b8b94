// Purpose: the camera's sample position inside the pixels of each frame, for graphs that average frames.
// Units: pixels, x to the right and y down. Source: Halton 1964, "Algorithm 247: Radical-inverse quasi-random
// point sequence"; Karis 2014, "High-Quality Temporal Supersampling".
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace weft::render {

// Mirrors the digits of `index` in `base` at the radix point: in [0, 1).
[[nodiscard]] double radical_inverse(uint32_t index, uint32_t base);

// The sample offset of this frame from the pixel's centre. The points 1 … `length` of Halton's sequence in
// bases 2 and 3 are used in turn, moved so that their mean is the centre. (0, 0) for lengths 0 and 1.
[[nodiscard]] glm::vec2 jitter_px(uint64_t frame, uint32_t length);

}  // namespace weft::render

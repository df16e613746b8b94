// Purpose: encodes linear RGB as the bytes of a Radiance picture (32-bit_rle_rgbe, without run lengths). Row
// 0 is the top row. The three channels of a texel share an exponent, so the error of a channel is at most
// 1/256 of the largest channel. Source: G. Ward, "Real Pixels", in "Graphics Gems II", 1991.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>

namespace weft::scene {

// `texels` has width_px × height_px values, which are finite, not negative and below 1e38.
[[nodiscard]] std::string encode_radiance(uint32_t width_px, uint32_t height_px,
                                          std::span<const glm::vec3> texels);

}  // namespace weft::scene

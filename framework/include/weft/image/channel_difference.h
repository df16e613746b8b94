// Purpose: differences of channels, texel by texel: PSNR, the largest one, and a map of them. Shapes:
// pictures of one size, not empty. Two linear pictures are compared in their raw values; otherwise both are
// compared as 8-bit display values (to_display(), rounded). Neither picture is the reference: all are
// symmetric. Source: PSNR is 10 log10(255² / mean square) over red, green and blue together.
#pragma once

#include "weft/image/image.h"

namespace weft::image {

// In dB over 8-bit display values, whatever the encoding; infinite for pictures without a difference.
[[nodiscard]] double psnr_db(const Image& a, const Image& b);

// In steps of 8 bits, or in raw values. Infinite where only one of the two is NaN; two NaN are the same.
[[nodiscard]] double largest_difference(const Image& a, const Image& b);

enum class Compared : uint8_t { as_they_are, as_displayed };

// The largest difference of a texel's channels: 1 is 255 steps, or 1 in raw values, which `as_displayed`
// rules out.
[[nodiscard]] Plane difference_map(const Image& a, const Image& b, Compared compared = Compared::as_they_are);

}  // namespace weft::image

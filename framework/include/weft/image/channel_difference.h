// Purpose: differences of channels, texel by texel: PSNR, the largest difference, and a map of differences.
// Shapes: two pictures of one size, not empty. Two linear pictures are compared by their raw values;
// otherwise both are converted to 8-bit display values (to_display(), rounded). All functions are symmetric.
// Source: PSNR is 10 log10(255² / mean square) over red, green and blue together.
#pragma once

#include "weft/image/image.h"

namespace weft::image {

// In dB, for 8-bit display values in all cases; infinite for equal pictures.
[[nodiscard]] double psnr_db(const Image& a, const Image& b);

// In 8-bit steps, or in raw values. Infinite if only one of two values is NaN; two NaNs are equal.
[[nodiscard]] double largest_difference(const Image& a, const Image& b);

enum class Compared : uint8_t { as_they_are, as_displayed };

// The largest difference of a texel's channels: 1 means 255 steps, or 1 in raw values; `as_displayed`
// excludes raw values.
[[nodiscard]] Plane difference_map(const Image& a, const Image& b, Compared compared = Compared::as_they_are);

}  // namespace weft::image

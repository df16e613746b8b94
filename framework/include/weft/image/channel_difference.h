// Purpose: compares two pictures channel by channel: PSNR, the largest difference, and a map of differences.
// Shapes: both pictures have the same size and are not empty. If both are linear, their raw values are
// compared. Otherwise both are converted to 8-bit display values (to_display(), then rounded). The order of
// the two pictures does not change a result. Source: PSNR is 10 log10(255² / mean square) over red, green and
// blue together.
#pragma once

#include "weft/image/image.h"

namespace weft::image {

// Returns the PSNR in dB; infinite for equal pictures. Always uses 8-bit display values, even for two linear
// pictures.
[[nodiscard]] double psnr_db(const Image& a, const Image& b);

// Returns the largest difference of two channels, in 8-bit steps or in raw values. It is infinite if one
// value is NaN and the other is not; two NaNs count as equal.
[[nodiscard]] double largest_difference(const Image& a, const Image& b);

enum class Compared : uint8_t { as_they_are, as_displayed };

// Returns for each texel the largest difference of its channels. If raw values are compared, their difference
// is returned unchanged. If 8-bit values are compared, their difference is divided by 255. With
// `as_displayed`, 8-bit display values are always compared.
[[nodiscard]] Plane difference_map(const Image& a, const Image& b, Compared compared = Compared::as_they_are);

}  // namespace weft::image

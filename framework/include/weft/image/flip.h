// Purpose: FLIP, a measure of the difference that a person sees when two pictures alternate on one screen:
// from 0 (none) to 1 (largest). Shapes: both pictures and the map have the same size. Units: pixels per
// degree of the observer's field of view. Preconditions: equal sizes, no empty pictures, no NaN. Source: P.
// Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. Fairchild, "FLIP: A Difference
// Evaluator for Alternating Images", HPG 2020. The colour pipeline of FLIP compares colours after blurring
// them like the eye, the feature pipeline compares edges and points. This implementation uses separable
// kernels for both.
#pragma once

#include "weft/image/image.h"

namespace weft::image {

// Resolution for an observer at a distance of 0.7 m from a screen that is 3840 px and 0.7 m wide.
inline constexpr float kPixelsPerDegree = 67;

// Returns the FLIP error of each texel. Linear pictures are first converted to display values (to_display()).
[[nodiscard]] Plane flip_map(const Image& reference, const Image& test,
                             float pixels_per_degree = kPixelsPerDegree);

// Returns the peak memory in bytes that flip_map() allocates in addition to its two pictures and the map.
[[nodiscard]] uint64_t flip_band_bytes(uint32_t width_px, uint32_t height_px,
                                       float pixels_per_degree = kPixelsPerDegree);

}  // namespace weft::image

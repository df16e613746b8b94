// Purpose: FLIP, the visible difference when a person flips between two pictures on one screen: 0 none, 1 the
// largest. Shapes: both pictures and the map have one size. Units: pixels per degree of the observer's field
// of view. Preconditions (asserted): equal sizes, no empty pictures, no NaN. Source: P. Andersson, J.
// Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. Fairchild, "FLIP: A Difference Evaluator for
// Alternating Images", HPG 2020. Its colour pipeline compares colours after the blur of the eye, its feature
// pipeline compares edges and points; here both use separable kernels.
#pragma once

#include "weft/image/image.h"

namespace weft::image {

// For a screen of 3840 px and 0.7 m, seen from 0.7 m.
inline constexpr float kPixelsPerDegree = 67;

// Linear pictures are first converted to display values (to_display()).
[[nodiscard]] Plane flip_map(const Image& reference, const Image& test,
                             float pixels_per_degree = kPixelsPerDegree);

// Peak memory that flip_map() allocates in addition to its pictures and the map.
[[nodiscard]] uint64_t flip_band_bytes(uint32_t width_px, uint32_t height_px,
                                       float pixels_per_degree = kPixelsPerDegree);

}  // namespace weft::image

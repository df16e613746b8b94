// Purpose: FLIP, the difference that a person sees who flips between two pictures on one screen: 0 none, 1
// the largest. Shapes: both pictures of one size; the map has that size too. Units: pixels per degree of the
// observer's field of view. Programmer errors: sizes that differ, empty pictures, NaN.
// Source: P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. Fairchild, "FLIP: A
// Difference Evaluator for Alternating Images", HPG 2020. Its colour pipeline compares what is left after the
// eye's blur, its feature pipeline edges and points; both are filtered with separable kernels here.
#pragma once

#include "weft/image/image.h"

namespace weft::image {

// A screen of 3840 px and 0.7 m, seen from 0.7 m.
inline constexpr float kPixelsPerDegree = 67;

// Linear pictures are made into display values first (to_display()).
[[nodiscard]] Plane flip_map(const Image& reference, const Image& test,
                             float pixels_per_degree = kPixelsPerDegree);

// The most memory that flip_map() allocates in addition to its pictures and the map.
[[nodiscard]] uint64_t flip_band_bytes(uint32_t width_px, uint32_t height_px,
                                       float pixels_per_degree = kPixelsPerDegree);

}  // namespace weft::image

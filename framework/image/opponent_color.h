// Purpose: the colour spaces in which FLIP filters and compares. Units: linear RGB in [0, 1] with Rec.709
// primaries; XYZ with Y = 1 for white; YCxCz with Y from -16 (black) to 100 (white); L*a*b* with L* from 0 to
// 100. White is RGB (1, 1, 1), so that greys have no chroma. Sources: IEC 61966-2-1. B. Kolpatzik and C.
// Bouman, "Optimized Error Diffusion for Image Display", 1992: YCxCz, which is L*a*b* without its cube root,
// so that filtering is linear. R. Hunt, "Light and Dark Adaptation and the Perception of Color", 1952. S.
// Abasi, M. Tehran, M. Fairchild, "Distance Metrics for Very Large Color Differences", 2019: HyAB.
#pragma once

#include <glm/glm.hpp>

namespace weft::image {

[[nodiscard]] glm::vec3 linear_to_ycxcz(glm::vec3 rgb);
// Converts YCxCz to linear RGB. The result may lie outside [0, 1].
[[nodiscard]] glm::vec3 ycxcz_to_linear(glm::vec3 ycxcz);

// Converts linear RGB to L*a*b*, and multiplies the chroma by 0.01 · L*, because colour differences are less
// visible in dark areas.
[[nodiscard]] glm::vec3 linear_to_hunt_lab(glm::vec3 rgb);

// Returns the distance of two colours in L*a*b*: the absolute difference of lightness plus the Euclidean
// distance of chroma.
[[nodiscard]] float hyab_distance(glm::vec3 lab_a, glm::vec3 lab_b);

}  // namespace weft::image

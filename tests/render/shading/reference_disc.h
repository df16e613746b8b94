// Purpose: reference for the reflection of a distant disc of uniform luminance: sums over many directions in
// double precision.
#pragma once

#include "tests/render/shading/reference_brdf.h"

namespace weft::test {

// Returns ∫ BRDF · n·l dω over the disc around `l`, divided by the irradiance of the disc on a plane that
// faces it. A narrow lobe is integrated over half vectors that are distributed as the facets are, a wide one
// over the disc. The normal of the surface is +y.
inline glm::dvec3 reference_disc(const ReferenceSurface& s, const glm::dvec3& v, const glm::dvec3& l,
                                 double radius_rad) {
    const double alpha = s.roughness * s.roughness, cap = 2 * kPi * (1 - std::cos(radius_rad));
    const bool narrow = alpha < radius_rad;
    const int side = narrow ? 200 : 60;
    const glm::dvec3 u = glm::normalize(
                         glm::cross(l, std::abs(l.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0))),
                     w = glm::cross(l, u);
    glm::dvec3 sum(0);
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const double share = (i + 0.5) / side, turn = 2 * kPi * (j + 0.25 + 0.5 * (i % 2)) / side;
            if (!narrow) {
                const double cosine = 1 - share * (1 - std::cos(radius_rad)),
                             sine = std::sqrt(1 - cosine * cosine);
                sum += reflected(s, v, cosine * l + sine * (std::cos(turn) * u + std::sin(turn) * w)) * cap;
                continue;
            }
            const double slope = alpha * std::sqrt(share / (1 - share));
            const glm::dvec3 h =
                glm::normalize(glm::dvec3(slope * std::cos(turn), 1, slope * std::sin(turn)));
            const glm::dvec3 from = 2 * glm::dot(v, h) * h - v;
            if (from.y <= 0 || glm::dot(from, l) < std::cos(radius_rad)) continue;
            // The density of this direction, for these half vectors, is D · n·h / (4 v·h).
            sum += reflected(s, v, from) * 4.0 * glm::dot(v, h) / (ggx(alpha, h.y) * h.y);
        }
    return sum / double(side * side) / (kPi * std::sin(radius_rad) * std::sin(radius_rad));
}

}  // namespace weft::test

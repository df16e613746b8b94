// Purpose: reference for reflection by an anisotropic metal, in double precision. It uses GGX with two
// roughnesses (Burley 2012), height-correlated Smith masking (Heitz 2014), and roughness and strength as in
// KHR_materials_anisotropy. Directions have components along tangent, bitangent and normal.
#pragma once

#include "tests/render/shading/reference_brdf.h"

namespace weft::test {

struct Stretched {
    // The parameter α of GGX along the tangent. Without anisotropy, α is the square of glTF's roughness.
    double along = 1;
    // The parameter α of GGX along the bitangent.
    double across = 1;
};

inline Stretched stretched(double roughness, double strength) {
    const double alpha = roughness * roughness;
    return {glm::mix(alpha, 1.0, strength * strength), alpha};
}

inline double ggx(const Stretched& s, const glm::dvec3& h) {
    const double d = std::pow(h.x / s.along, 2) + std::pow(h.y / s.across, 2) + h.z * h.z;
    return 1 / (kPi * s.along * s.across * d * d);
}

inline double smith_lambda(const Stretched& s, const glm::dvec3& w) {
    const double slope2 = (std::pow(s.along * w.x, 2) + std::pow(s.across * w.y, 2)) / (w.z * w.z);
    return (std::sqrt(1 + slope2) - 1) / 2;
}

// Returns the BRDF f times n·l for a metal; 0 for light below the horizon.
inline glm::dvec3 reflected_by_metal(const Stretched& s, const glm::dvec3& color, const glm::dvec3& v,
                                     const glm::dvec3& l) {
    if (l.z <= 0) return glm::dvec3(0);
    const glm::dvec3 h = glm::normalize(v + l);
    const glm::dvec3 fresnel = color + (glm::dvec3(1) - color) * std::pow(1 - glm::dot(v, h), 5);
    const double g2 = 1 / (1 + smith_lambda(s, v) + smith_lambda(s, l));
    return fresnel * (ggx(s, h) * g2 / (4 * v.z));
}

}  // namespace weft::test

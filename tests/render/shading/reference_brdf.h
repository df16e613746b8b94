// Purpose: reference for the reflection of surfaces in double precision, written only from the papers: GGX
// (Trowbridge and Reitz 1975, Walter et al. 2007), height-correlated Smith masking (Heitz 2014), Schlick's
// Fresnel term. The base reflects its colour, but at most the light that the coat does not reflect.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace weft::test {

inline constexpr double kPi = 3.14159265358979323846;

// Returns Λ of Smith's masking function for a direction whose cosine to the normal is `cosine`.
inline double smith_lambda(double alpha, double cosine) {
    const double tan2 = (1 - cosine * cosine) / (cosine * cosine);
    return (std::sqrt(1 + alpha * alpha * tan2) - 1) / 2;
}

inline double ggx(double alpha, double n_h) {
    const double d = n_h * n_h * (alpha * alpha - 1) + 1;
    return alpha * alpha / (kPi * d * d);
}

inline double smith_g2_correlated(double alpha, double n_l, double n_v) {
    return 1 / (1 + smith_lambda(alpha, n_l) + smith_lambda(alpha, n_v));
}

struct ReferenceSurface {
    glm::dvec3 normal{0, 1, 0};
    glm::dvec3 base_color{1};
    double metallic = 0;
    double roughness = 1;
    glm::dvec3 dielectric_f0{0.04};
    double specular = 1;
    glm::dvec3 energy{1};  // Factor for the specular reflection.
};

// Returns the BRDF f times n·l for each channel; 0 for light below the horizon.
inline glm::dvec3 reflected(const ReferenceSurface& s, const glm::dvec3& v, const glm::dvec3& l) {
    const double n_l = glm::dot(s.normal, l);
    if (n_l <= 0) return glm::dvec3(0);
    const double n_v = std::max(glm::dot(s.normal, v), 1e-4);
    const glm::dvec3 h = glm::normalize(v + l);
    const double alpha = std::max(s.roughness * s.roughness, 0.002);
    const glm::dvec3 f0 = glm::mix(s.dielectric_f0 * s.specular, s.base_color, s.metallic);
    const double f90 = glm::mix(s.specular, 1.0, s.metallic);
    const glm::dvec3 f = f0 + (glm::dvec3(f90) - f0) * std::pow(1 - glm::dot(v, h), 5);
    const double g2 = smith_g2_correlated(alpha, n_l, n_v);
    const double d = ggx(alpha, std::min(1.0, glm::dot(s.normal, h)));
    const glm::dvec3 diffuse =
        glm::min(s.base_color * (1 - s.metallic), glm::dvec3(1 - std::max({f.x, f.y, f.z})));
    return (diffuse / kPi + f * s.energy * (d * g2 / (4 * n_l * n_v))) * n_l;
}

}  // namespace weft::test

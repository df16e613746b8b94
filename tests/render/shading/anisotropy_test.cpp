// Tests the reference for anisotropic reflection (reference_anisotropy.h) against its known properties.
#include <gtest/gtest.h>

#include <array>

#include "tests/render/shading/reference_anisotropy.h"

namespace weft::test {
namespace {

// Returns the integral of value(h)·D·(n·h) over the hemisphere of half vectors h, where D is the anisotropic
// GGX distribution. The samples are directions that are uniform in u = cos θ and φ. Their slopes are
// multiplied by the two roughnesses. With the weight 2 u, the samples then have the density D·(n·h). A
// `value` that divides by n·h is unbounded at grazing directions, but the weight is small there.
template <class Value>
double mean_over_normals(const Stretched& s, const Value& value) {
    constexpr int kSteps = 1200;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
            const double u = (i + 0.5) / kSteps, phi = 2 * kPi * (j + 0.5) / kSteps;
            const double slope = std::sqrt(1 - u * u) / u;
            sum += 2 * u *
                   value(glm::normalize(
                       glm::dvec3(s.along * slope * std::cos(phi), s.across * slope * std::sin(phi), 1)));
        }
    return sum / kSteps / kSteps;
}

TEST(ReferenceAnisotropy, DistributionIsNormalised) {
    // The integral ∫ D·(n·h) dω must be 1. With x = tan θ cos φ and y = tan θ sin φ, it equals
    // ∫ D·cos⁴θ dx dy.
    for (const auto& [roughness, strength] :
         {std::pair{0.3, 0.0}, std::pair{0.3, 0.5}, std::pair{0.3, 1.0}, std::pair{0.6, 0.8}}) {
        const Stretched s = stretched(roughness, strength);
        constexpr int kSteps = 2000;
        double sum = 0;
        for (int i = 0; i < kSteps; ++i)
            for (int j = 0; j < kSteps; ++j) {
                // x and y are tangents of the angles a and b, so that a finite grid of angles covers the
                // infinite plane. Each axis is scaled by its roughness, so that the samples cover the lobe.
                const double a = ((i + 0.5) / kSteps - 0.5) * kPi, b = ((j + 0.5) / kSteps - 0.5) * kPi;
                const double x = s.along * std::tan(a), y = s.across * std::tan(b);
                const double area = s.along * s.across / std::pow(std::cos(a) * std::cos(b), 2);
                const double cos2 = 1 / (1 + x * x + y * y);
                const glm::dvec3 h(x * std::sqrt(cos2), y * std::sqrt(cos2), std::sqrt(cos2));
                sum += ggx(s, h) * cos2 * cos2 * area;
            }
        EXPECT_NEAR(sum * std::pow(kPi / kSteps, 2), 1, 1e-4) << roughness << ", " << strength;
    }
}

TEST(ReferenceAnisotropy, MaskingLeavesTheProjectedArea) {
    // The integral ∫ D·G1(v)·max(v·h, 0) dω must be n·v (Heitz 2014, equation 15). mean_over_normals()
    // already weights the half vectors by D·(n·h), so the value is divided by n·h, which is h.z. G1(v) =
    // 1 / (1 + Λ(v)) does not depend on h, so it is applied after the integration.
    const Stretched s = stretched(0.5, 0.7);
    for (const glm::dvec3 v :
         {glm::dvec3(0.8, 0, 0.6), glm::dvec3(0, 0.8, 0.6), glm::dvec3(0.6, 0.6, 0.52915026)}) {
        const double seen =
            mean_over_normals(s, [&](const glm::dvec3& h) { return std::max(0.0, glm::dot(v, h)) / h.z; });
        EXPECT_NEAR(seen / (1 + smith_lambda(s, v)), v.z, 1e-4);
    }
}

TEST(ReferenceAnisotropy, WithoutStrengthItIsTheIsotropicOne) {
    ReferenceSurface plain;
    plain.normal = {0, 0, 1};
    plain.base_color = {0.9, 0.6, 0.3};
    plain.metallic = 1;
    const std::array<glm::dvec3, 3> lights{glm::normalize(glm::dvec3(0.3, 0.4, 1)),
                                           glm::normalize(glm::dvec3(-0.9, 0.1, 0.2)), glm::dvec3(0, 0, 1)};
    const glm::dvec3 v = glm::normalize(glm::dvec3(0.2, -0.5, 0.7));
    for (const double roughness : {0.1, 0.4, 1.0})
        for (const glm::dvec3& l : lights) {
            plain.roughness = roughness;
            const glm::dvec3 wanted = reflected(plain, v, l);
            const glm::dvec3 found = reflected_by_metal(stretched(roughness, 0), plain.base_color, v, l);
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], wanted[c], wanted[c] * 1e-9);
        }
}

}  // namespace
}  // namespace weft::test

// Tests the reference BRDF (reference_brdf.h) against known values: Smith terms, normalisation, split-sum
// scale and bias, energy.
#include <gtest/gtest.h>

#include <array>

#include "tests/render/shading/reference_brdf.h"

namespace weft::test {
namespace {

TEST(ReferenceBrdf, SmithTermsAtAlphaHalfAndSixtyDegrees) {
    EXPECT_NEAR(smith_lambda(0.5, 0.5), 0.161438, 1e-6);
    EXPECT_NEAR(1 / (1 + smith_lambda(0.5, 0.5)), 0.861002, 1e-6);
    EXPECT_NEAR(smith_g2_correlated(0.5, 0.5, 0.5), 0.755929, 1e-6);
    EXPECT_NEAR(ggx(0.5, 0.5), 0.120543, 1e-6);
}

TEST(ReferenceBrdf, DistributionIsNormalised) {
    for (const double alpha : {0.05, 0.25, 0.5, 1.0}) {
        // The integral ∫ D·(n·h) dω over the hemisphere must be 1. It is computed as an integral over t
        // from 0 to 1 with tan²θ = alpha²·t / (1 − t), because this resolves narrow lobes.
        double sum = 0;
        constexpr int kSteps = 200000;
        for (int i = 0; i < kSteps; ++i) {
            const double t = (i + 0.5) / kSteps;
            const double tan2 = alpha * alpha * t / (1 - t);
            const double cos2 = 1 / (1 + tan2);
            // Derivative of tan²θ with respect to t.
            const double jacobian = alpha * alpha / ((1 - t) * (1 - t));
            sum += ggx(alpha, std::sqrt(cos2)) * kPi * cos2 * cos2 * jacobian / kSteps;
        }
        EXPECT_NEAR(sum, 1, 1e-6) << "alpha " << alpha;
    }
}

struct ScaleBias {
    double scale = 0, bias = 0;
};

// Computes the two integrals of the split sum (Karis 2013). The samples are visible normals (Heitz 2018,
// "Sampling the GGX Distribution of Visible Normals"), so that the remaining integrand, G2 / G1, is bounded.
ScaleBias directional_albedo(double roughness, double n_v) {
    const double alpha = roughness * roughness;
    const glm::dvec3 v(std::sqrt(1 - n_v * n_v), 0, n_v);
    const glm::dvec3 stretched = glm::normalize(glm::dvec3(alpha * v.x, alpha * v.y, v.z));
    const glm::dvec3 t1(0, 1, 0), t2 = glm::cross(stretched, t1);
    ScaleBias sum;
    constexpr int kSamples = 1 << 19;
    for (int i = 0; i < kSamples; ++i) {
        // The samples are Hammersley points. They are distributed evenly, so the error is nearly proportional
        // to 1 / kSamples.
        uint32_t bits = static_cast<uint32_t>(i);
        double mirrored = 0;
        for (double half = 0.5; bits != 0; bits >>= 1, half /= 2) mirrored += (bits & 1) * half;
        const double radius = std::sqrt((i + 0.5) / kSamples), phi = 2 * kPi * mirrored;
        const double p1 = radius * std::cos(phi), share = 0.5 * (1 + stretched.z);
        const double p2 = (1 - share) * std::sqrt(1 - p1 * p1) + share * radius * std::sin(phi);
        const glm::dvec3 m = p1 * t1 + p2 * t2 + std::sqrt(std::max(0.0, 1 - p1 * p1 - p2 * p2)) * stretched;
        const glm::dvec3 h = glm::normalize(glm::dvec3(alpha * m.x, alpha * m.y, std::max(0.0, m.z)));
        const double v_h = glm::dot(v, h);
        const double n_l = 2 * v_h * h.z - n_v;
        if (n_l <= 0) continue;
        const double weight = smith_g2_correlated(alpha, n_l, n_v) * (1 + smith_lambda(alpha, n_v));
        const double fresnel = std::pow(1 - v_h, 5);
        sum.scale += (1 - fresnel) * weight / kSamples;
        sum.bias += fresnel * weight / kSamples;
    }
    return sum;
}

TEST(ReferenceBrdf, SplitSumScaleAndBias) {
    constexpr std::array kCosines{.10, .25, .50, .75, 1.0};
    struct Row {
        double roughness;
        std::array<ScaleBias, 5> values;
    };
    const std::array rows{
        Row{.1, {{{.4158, .5784}, {.7629, .2362}, {.9683, .0314}, {.9989, .0010}, {.9999, 0}}}},
        Row{.3, {{{.5630, .3214}, {.7535, .1783}, {.9427, .0324}, {.9847, .0018}, {.9907, 0}}}},
        Row{.5, {{{.7519, .1397}, {.7593, .0808}, {.8349, .0223}, {.8888, .0027}, {.9158, 0}}}},
        Row{.8, {{{.7889, .0442}, {.6952, .0229}, {.6143, .0069}, {.5741, .0014}, {.5551, 0}}}},
        Row{1., {{{.7363, .0239}, {.5868, .0109}, {.4477, .0030}, {.3639, .0006}, {.3068, 0}}}},
    };
    for (const Row& row : rows) {
        for (size_t i = 0; i < kCosines.size(); ++i) {
            const ScaleBias found = directional_albedo(row.roughness, kCosines[i]);
            EXPECT_NEAR(found.scale, row.values[i].scale, 1e-4) << row.roughness << " at " << kCosines[i];
            EXPECT_NEAR(found.bias, row.values[i].bias, 1e-4) << row.roughness << " at " << kCosines[i];
        }
    }
}

TEST(ReferenceBrdf, RoughWhiteMetalHasTheClosedFormAlbedo) {
    for (const double n_v : {.2, .5, .9}) {
        const ScaleBias found = directional_albedo(1, n_v);
        EXPECT_NEAR(found.scale + found.bias, 1 - n_v * std::log(1 + 1 / n_v), 1e-4) << n_v;
    }
}

TEST(ReferenceBrdf, WithoutSpecularADielectricIsLambert) {
    ReferenceSurface s;
    s.specular = 0;
    s.roughness = 0.3;
    const glm::dvec3 l = glm::normalize(glm::dvec3(0.3, 1, 0.2)),
                     v = glm::normalize(glm::dvec3(-0.5, 0.4, 0.1));
    EXPECT_NEAR(reflected(s, v, l).x, l.y / kPi, 1e-12);
}

}  // namespace
}  // namespace weft::test

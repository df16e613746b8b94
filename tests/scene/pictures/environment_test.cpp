// Purpose: compares the mips and the irradiance of environments with values that are computed analytically.
#include "weft/scene/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/gtc/packing.hpp>
#include <numbers>

namespace weft::scene {
namespace {

// Returns the direction through the centre of a texel: the middle column points to -z, the columns to its
// right turn towards +x, and the top row points to +y.
glm::dvec3 direction_of(uint32_t x, uint32_t y, uint32_t width, uint32_t height) {
    const double azimuth = ((x + 0.5) / width - 0.5) * 2 * std::numbers::pi,
                 polar = (y + 0.5) / height * std::numbers::pi;
    return {std::sin(polar) * std::sin(azimuth), std::cos(polar), -std::sin(polar) * std::cos(azimuth)};
}

Environment environment_of(uint32_t width, uint32_t height,
                           const std::function<glm::dvec3(glm::dvec3)>& radiance) {
    std::vector<glm::vec3> texels;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) texels.emplace_back(radiance(direction_of(x, y, width, height)));
    return build_environment(width, height, texels);
}

glm::dvec3 irradiance_over_pi(const Environment& environment, glm::dvec3 n) {
    const std::array<float, 9> basis = environment_basis(glm::vec3(n));
    glm::dvec3 sum(0);
    for (size_t i = 0; i < basis.size(); ++i)
        sum += glm::dvec3(environment.irradiance_over_pi[i]) * double(basis[i]);
    return sum;
}

const std::vector<glm::dvec3> kNormals{{1, 0, 0},
                                       {0, 1, 0},
                                       {0, 0, 1},
                                       {-1, 0, 0},
                                       {0, -1, 0},
                                       {0, 0, -1},
                                       glm::normalize(glm::dvec3(1, 2, 3)),
                                       glm::normalize(glm::dvec3(-3, 1, 2)),
                                       glm::normalize(glm::dvec3(2, -3, -1))};

void expect_irradiance(const Environment& environment, const std::function<double(glm::dvec3)>& expected,
                       double tolerance) {
    for (const glm::dvec3& n : kNormals)
        EXPECT_NEAR(irradiance_over_pi(environment, n).r, expected(n), tolerance)
            << n.x << " " << n.y << " " << n.z;
}

TEST(Environment, AConstantOneLightsEverySideAlike) {
    // The integrals over texels are exact, so the result must not depend on the size of the picture. The
    // unusual size 7 × 3 tests this.
    expect_irradiance(
        environment_of(7, 3, [](glm::dvec3) { return glm::dvec3(2.5); }), [](glm::dvec3) { return 2.5; },
        1e-6);
}

TEST(Environment, ALinearOneLightsByTwoThirds) {
    const glm::dvec3 slope(0.3, -0.2, 0.5);
    expect_irradiance(
        environment_of(512, 256, [&](glm::dvec3 w) { return glm::dvec3(1 + glm::dot(slope, w)); }),
        [&](glm::dvec3 n) { return 1 + 2.0 / 3 * glm::dot(slope, n); }, 1e-4);
}

TEST(Environment, ASquareLightsByAQuarter) {
    for (int axis = 0; axis < 3; ++axis)
        expect_irradiance(
            environment_of(512, 256, [&](glm::dvec3 w) { return glm::dvec3(w[axis] * w[axis]); }),
            [&](glm::dvec3 n) { return 1.0 / 3 + 0.25 * (n[axis] * n[axis] - 1.0 / 3); }, 1e-4);
}

TEST(Environment, AProductOfAxesLightsByAQuarter) {
    for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {0, 2}})
        expect_irradiance(
            environment_of(512, 256, [&](glm::dvec3 w) { return glm::dvec3(1 + w[a] * w[b]); }),
            [&](glm::dvec3 n) { return 1 + 0.25 * n[a] * n[b]; }, 1e-4);
}

TEST(Environment, HalfTheSkyLightsByTheShareThatIsSeen) {
    expect_irradiance(
        environment_of(64, 32, [](glm::dvec3 w) { return glm::dvec3(w.y > 0 ? 1 : 0); }),
        [](glm::dvec3 n) { return (1 + n.y) / 2; }, 1e-6);
}

// The irradiance is stored as spherical harmonics of the orders 0 to 2. For a small sun alone, their sum is
// negative in some directions, down to -4 % of the value towards the sun. A surface that faces such a
// direction must still receive the sky's light.
TEST(Environment, ASunDoesNotDarkenTheOtherSides) {
    const glm::dvec3 sun = glm::normalize(glm::dvec3(1, 1, -1));
    const Environment environment = environment_of(128, 64, [&](glm::dvec3 w) {
        return glm::dvec3(0.2, 0.5, 1) + (glm::dot(w, sun) > 0.998 ? 4000.0 : 0.0);
    });
    for (const glm::dvec3& n : kNormals) {
        const glm::dvec3 found = irradiance_over_pi(environment, n);
        EXPECT_GE(found.r, 0.2 * 0.65) << n.x << " " << n.y << " " << n.z;
        EXPECT_GE(found.b, 1 * 0.65) << n.x << " " << n.y << " " << n.z;
    }
    EXPECT_GT(irradiance_over_pi(environment, sun).r, 8 * irradiance_over_pi(environment, -sun).r);
}

TEST(Environment, TheLastMipIsTheMeanOverTheSphere) {
    for (const auto& [width, height] : {std::pair{64u, 32u}, {37u, 19u}, {5u, 1u}, {1u, 9u}}) {
        const Environment environment = environment_of(
            width, height, [](glm::dvec3 w) { return glm::dvec3(1 + w.y * 0.9, 1 + w.x, w.y * w.y); });
        double all = 0;
        glm::dvec3 sum(0);
        for (uint32_t y = 0; y < height; ++y)
            for (uint32_t x = 0; x < width; ++x) {
                const double angle =
                    std::cos(std::numbers::pi * y / height) - std::cos(std::numbers::pi * (y + 1) / height);
                const glm::dvec3 w = direction_of(x, y, width, height);
                sum += glm::dvec3(1 + w.y * 0.9, 1 + w.x, w.y * w.y) * angle;
                all += angle;
            }
        ASSERT_EQ(environment.mips.back().size(), 1u);
        const glm::vec3 last = glm::unpackF3x9_E1x5(environment.mips.back()[0]);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(last[c], sum[c] / all, 2e-3) << width << "x" << height;
    }
}

// Texels near a pole cover very narrow areas. In a mip, neighbouring texels of the row at a pole must differ
// little; otherwise bright and dark rays would be visible around the pole.
TEST(Environment, MipsAreEvenAroundThePoles) {
    Environment environment =
        environment_of(128, 64, [](glm::dvec3 w) { return glm::dvec3(std::atan2(w.x, -w.z) > 0 ? 1 : 0); });
    const std::vector<uint32_t>& mip = environment.mips.at(2);  // Mip level 2 has 32 × 16 texels.
    float least = 1, most = 0;
    for (size_t x = 0; x < 32; ++x) {
        least = std::min(least, glm::unpackF3x9_E1x5(mip[x]).r);
        most = std::max(most, glm::unpackF3x9_E1x5(mip[x]).r);
    }
    // In the row nearest to the pole, ten texels together are as wide as one texel at the equator. So each
    // texel of this row is the average of about ten neighbours. Half of the picture is 0 and half is 1, so
    // the averages at opposite places add up to 1. Neighbouring texels differ little. Without the averages,
    // they would jump from 0 to 1.
    EXPECT_NEAR(least + most, 1, 1e-2);
    float steepest = 0;
    for (size_t x = 0; x < 32; ++x)
        steepest = std::max(
            steepest, std::abs(glm::unpackF3x9_E1x5(mip[x]).r - glm::unpackF3x9_E1x5(mip[(x + 1) % 32]).r));
    EXPECT_LT(steepest, 0.2f);
}

TEST(Environment, WhatOutshinesTheFormatIsScaled) {
    std::vector<glm::vec3> texels(8, glm::vec3(1));
    texels[3] = glm::vec3(1.6e9f, 1e5f, 1);
    const Environment environment = build_environment(4, 2, texels);
    EXPECT_GT(environment.scale, 1);
    const glm::vec3 sun = glm::unpackF3x9_E1x5(environment.mips[0][3]) * environment.scale;
    EXPECT_NEAR(sun.r, 1.6e9f, 1.6e9f / 256);
}

}  // namespace
}  // namespace weft::scene

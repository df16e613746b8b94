// Purpose: takes suns of known direction, size and light out of pictures that the tests make.
#include "scene/pictures/extract_suns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace weft::scene {
namespace {

constexpr double kPi_rad = std::numbers::pi;
using Radiance = std::function<glm::dvec3(const glm::dvec3&)>;

struct Picture {
    uint32_t width = 0, height = 0;
    std::vector<glm::vec3> texels;
    [[nodiscard]] glm::vec3& at(uint32_t x, uint32_t y) { return texels[size_t{y} * width + x]; }
};

glm::dvec3 direction_at(double x, double y, const Picture& picture) {
    const double azimuth = (x / picture.width - 0.5) * 2 * kPi_rad, polar = y / picture.height * kPi_rad;
    return {std::sin(polar) * std::sin(azimuth), std::cos(polar), -std::sin(polar) * std::cos(azimuth)};
}

// Each texel is the mean over its solid angle. It is computed from many points if the corners of the texel
// differ.
Picture picture_of(uint32_t width, uint32_t height, const Radiance& radiance) {
    Picture picture{width, height, std::vector<glm::vec3>(size_t{width} * height)};
    const auto mean = [&](uint32_t x, uint32_t y, int points) {
        glm::dvec3 sum(0);
        double weights = 0;
        for (int i = 0; i < points * points; ++i) {
            const double row = y + (i / points + 0.5) / points, weight = std::sin(row / height * kPi_rad);
            sum += weight * radiance(direction_at(x + (i % points + 0.5) / points, row, picture));
            weights += weight;
        }
        return sum / weights;
    };
    for (uint32_t y = 0; y < height; ++y) {
        for (uint32_t x = 0; x < width; ++x) {
            double least = std::numeric_limits<double>::max(), most = 0;
            for (int i = 0; i < 9; ++i) {
                const double g = radiance(direction_at(x + i % 3 / 2.0, y + i / 3 / 2.0, picture)).g;
                least = std::min(least, g);
                most = std::max(most, g);
            }
            picture.at(x, y) = glm::vec3(most > 1.5 * least ? mean(x, y, 64) : mean(x, y, 1));
        }
    }
    return picture;
}

glm::dvec3 toward(double azimuth_deg, double height_deg) {
    const double a = glm::radians(azimuth_deg), h = glm::radians(height_deg);
    return {std::cos(h) * std::sin(a), std::sin(h), -std::cos(h) * std::cos(a)};
}

// A disc with the radiance `inside` on a sky of uniform radiance.
Radiance disc(const glm::dvec3& to_sun, double radius_rad, double inside, const Radiance& sky) {
    return [=](const glm::dvec3& d) {
        return glm::dot(d, to_sun) > std::cos(radius_rad) ? glm::dvec3(1, 0.9, 0.7) * inside : sky(d);
    };
}

const Radiance kSky = [](const glm::dvec3&) { return glm::dvec3(0.5, 0.75, 1); };

std::vector<PictureSun> extract(Picture& picture) {
    return extract_suns(picture.width, picture.height, picture.texels);
}

struct SunCase {
    const char* name;
    double azimuth_deg, height_deg, radius_deg;
};

class OneSun : public ::testing::TestWithParam<SunCase> {};

TEST_P(OneSun, HasItsDirectionSizeAndLightAndLeavesTheSky) {
    const SunCase& c = GetParam();
    const double radius = glm::radians(c.radius_deg), inside = 4e5;
    const glm::dvec3 to_sun = toward(c.azimuth_deg, c.height_deg);
    Picture picture = picture_of(256, 128, disc(to_sun, radius, inside, kSky));
    const std::vector<PictureSun> suns = extract(picture);
    ASSERT_EQ(suns.size(), 1u);
    const double texel_rad = kPi_rad / 128;
    const double off = glm::length(glm::dvec3(suns[0].to_sun) - to_sun) / texel_rad;
    // The sky is so much darker than the disc that its part inside of the disc does not matter.
    const double expected = inside * kPi_rad * std::sin(radius) * std::sin(radius);
    const glm::dvec3 found = glm::dvec3(suns[0].illuminance_lx) / (glm::dvec3(1, 0.9, 0.7) * expected);
    std::printf("%s: off by %.4f texels, light %.5f, radius %.4f of the disc's\n", c.name, off, found.x,
                double{suns[0].angular_radius_rad} / radius);
    EXPECT_LT(off, 0.1);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], 1, 0.005);
    // Where all texels end in one point, at a pole, more of the spread is due to texels than elsewhere.
    EXPECT_NEAR(suns[0].angular_radius_rad, radius, (std::abs(c.height_deg) > 85 ? 0.05 : 0.01) * radius);
    for (const glm::vec3& texel : picture.texels) ASSERT_EQ(texel, glm::vec3(0.5, 0.75, 1));
}

INSTANTIATE_TEST_SUITE_P(Pictures, OneSun,
                         ::testing::Values(SunCase{"High", 40, 50, 2.5}, SunCase{"Low", -100, 3, 4},
                                           SunCase{"Seam", 180, 20, 3}, SunCase{"NearSeam", 178.7, -30, 2.2},
                                           SunCase{"Zenith", 0, 90, 3.1640625},
                                           SunCase{"NearZenith", 70, 88, 3.5}, SunCase{"Nadir", 30, -89, 3},
                                           SunCase{"Large", 10, 30, 9}),
                         [](const auto& c) { return std::string(c.param.name); });

// The illuminance of every plane that sees the whole sun is the same before and after.
TEST(ExtractSuns, KeepTheIlluminance) {
    const glm::dvec3 to_sun = toward(33, 40);
    const Radiance sky = [](const glm::dvec3& d) { return glm::dvec3(2, 3, 5) * (1.5 + d.y); };
    const Picture before = picture_of(512, 256, disc(to_sun, 0.06, 2e4, sky));
    Picture after = before;
    const std::vector<PictureSun> suns = extract(after);
    ASSERT_EQ(suns.size(), 1u);
    const auto illuminance = [](const Picture& picture, const glm::dvec3& n) {
        glm::dvec3 sum(0);
        for (uint32_t y = 0; y < picture.height; ++y) {
            const double angle =
                (std::cos(kPi_rad * y / picture.height) - std::cos(kPi_rad * (y + 1) / picture.height)) * 2 *
                kPi_rad / picture.width;
            for (uint32_t x = 0; x < picture.width; ++x)
                sum += glm::dvec3(picture.texels[size_t{y} * picture.width + x]) * angle *
                       std::max(0.0, glm::dot(n, direction_at(x + 0.5, y + 0.5, picture)));
        }
        return sum;
    };
    for (const glm::dvec3& n : {to_sun, glm::dvec3(0, 1, 0), glm::normalize(glm::dvec3(1, 0.3, -0.2))}) {
        const glm::dvec3 wanted = illuminance(before, n);
        const glm::dvec3 found =
            illuminance(after, n) +
            glm::dvec3(suns[0].illuminance_lx) * std::max(0.0, glm::dot(n, glm::dvec3(suns[0].to_sun)));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c] / wanted[c], 1, 0.005);
    }
}

TEST(ExtractSuns, SortsTwoSunsAndFindsAWindow) {
    const glm::dvec3 small = toward(-60, 30), large = toward(80, 45);
    // A window of 4.2° × 2.1°, seen straight on.
    const Radiance window = [&](const glm::dvec3& d) {
        const double azimuth = std::atan2(d.x, -d.z), height = std::asin(d.y);
        const bool inside = std::abs(azimuth) < glm::radians(2.1) && std::abs(height) < glm::radians(1.05);
        return inside ? glm::dvec3(4e4) : kSky(d);
    };
    Picture picture = picture_of(512, 256, disc(large, 0.05, 9e4, disc(small, 0.04, 9e4, window)));
    const std::vector<PictureSun> suns = extract(picture);
    ASSERT_EQ(suns.size(), 3u);
    EXPECT_GT(glm::dot(glm::dvec3(suns[0].to_sun), large), 0.9999);
    EXPECT_GT(glm::dot(glm::dvec3(suns[1].to_sun), small), 0.9999);
    EXPECT_GT(glm::dot(glm::dvec3(suns[2].to_sun), glm::dvec3(0, 0, -1)), 0.9999);
    EXPECT_NEAR(suns[2].illuminance_lx.r, 4e4 * 4 * glm::radians(2.1) * glm::radians(1.05), 40);
}

TEST(ExtractSuns, LeaveSourcesThatAreNotSmallDiscs) {
    const auto band = [](const glm::dvec3& d) {
        return std::abs(d.y) < 0.05 ? glm::dvec3(1000) : glm::dvec3(1);  // The whole horizon.
    };
    const auto tube = [](const glm::dvec3& d) {
        return std::abs(d.y) < 0.02 && std::abs(d.x) < 0.17 && d.z < 0 ? glm::dvec3(1000) : glm::dvec3(1);
    };
    const auto window = [](const glm::dvec3& d) {  // 16° × 10°.
        return std::abs(d.y) < 0.09 && std::abs(d.x) < 0.14 && d.z < 0 ? glm::dvec3(1000) : glm::dvec3(1);
    };
    const auto half = [](const glm::dvec3& d) { return d.x > 0.3 ? glm::dvec3(1000) : glm::dvec3(1); };
    const auto clouds = [](const glm::dvec3& d) { return glm::dvec3(d.x > 0.9 ? 25 : 1); };
    const auto faint = disc(toward(10, 40), 0.02, 40, kSky);  // Bright, but hardly any light.
    for (const Radiance& radiance : std::vector<Radiance>{band, tube, window, half, clouds, faint, kSky}) {
        const Picture before = picture_of(256, 128, radiance);
        Picture picture = before;
        EXPECT_TRUE(extract(picture).empty());
        EXPECT_EQ(picture.texels, before.texels);
    }
}

// The haze and the sun are one region, which is too large for a sun. The haze stays in the picture.
TEST(ExtractSuns, FindTheSunInABrightHaze) {
    const glm::dvec3 to_sun = toward(-70, 8);
    const Radiance haze = [&](const glm::dvec3& d) {
        const double off = std::acos(std::clamp(glm::dot(d, to_sun), -1.0, 1.0));
        return glm::dvec3(1, 0.8, 0.5) * (1 + 300 * std::exp(-off / 0.15));
    };
    const double radius = 0.03, inside = 8e4;
    const Radiance sky = disc(to_sun, radius, inside, haze);
    Picture picture = picture_of(512, 256, sky);
    const std::vector<PictureSun> suns = extract(picture);
    ASSERT_EQ(suns.size(), 1u);
    EXPECT_GT(glm::dot(glm::dvec3(suns[0].to_sun), to_sun), 0.9999);
    EXPECT_NEAR(suns[0].angular_radius_rad, radius, 0.1 * radius);
    EXPECT_NEAR(suns[0].illuminance_lx.r / (inside * kPi_rad * radius * radius), 1, 0.01);
    float most = 0;
    for (const glm::vec3& texel : picture.texels) most = std::max(most, texel.r);
    EXPECT_GT(most, 150);
    EXPECT_LT(most, 302);
}

TEST(ExtractSuns, TakeTheBrightestSixteenOfManyRegions) {
    Picture picture = picture_of(256, 128, [](const glm::dvec3&) { return glm::dvec3(0.001); });
    for (uint32_t i = 0; i < 20; ++i) picture.at(5 + 12 * i, 64) = glm::vec3(1000.0f + float(i));
    const std::vector<PictureSun> suns = extract(picture);
    ASSERT_EQ(suns.size(), kMostSuns);
    for (uint32_t i = 0; i < 20; ++i) EXPECT_EQ(picture.at(5 + 12 * i, 64).r > 1, i < 4) << i;
    // A thousand regions that have less than 2 % of the light each.
    Picture dots = picture_of(256, 128, [](const glm::dvec3&) { return glm::dvec3(1); });
    for (uint32_t y = 8; y < 120; y += 3)
        for (uint32_t x = 0; x < 255; x += 3) dots.at(x, y) = glm::vec3(1e5f);
    EXPECT_TRUE(extract(dots).empty());
}

TEST(ExtractSuns, AcceptBadTexelsAndTinyPictures) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity(),
                most = std::numeric_limits<float>::max();
    Picture bad = picture_of(32, 16, kSky);
    bad.at(3, 4) = {nan, inf, -inf};
    bad.at(20, 0) = {-5, 1, nan};
    bad.at(10, 8) = glm::vec3(most);
    for (const PictureSun& sun : extract(bad)) EXPECT_TRUE(std::isfinite(sun.illuminance_lx.r));
    for (const glm::vec3& texel : bad.texels)
        for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(texel[c]) && texel[c] >= 0);
    for (const auto& [width, height] : {std::pair{1u, 1u}, {2u, 1u}, {1u, 2u}, {3u, 3u}}) {
        for (const float value : {0.0f, 1.0f, 1e6f, nan, inf, -1.0f, most}) {
            Picture tiny{width, height, std::vector<glm::vec3>(size_t{width} * height, glm::vec3(1))};
            tiny.texels[0] = glm::vec3(value);
            for (const PictureSun& sun : extract(tiny)) EXPECT_TRUE(std::isfinite(sun.illuminance_lx.r));
        }
    }
    Picture black{8, 4, std::vector<glm::vec3>(32, glm::vec3(0))};
    EXPECT_TRUE(extract(black).empty());
    EXPECT_TRUE(extract_suns(0, 0, {}).empty());
}

}  // namespace
}  // namespace weft::scene

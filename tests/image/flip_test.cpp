// Purpose: compares FLIP with closed formulas where they exist, and otherwise with a second implementation.
#include "weft/image/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "image/flip_kernels.h"
#include "image/opponent_color.h"
#include "tests/image/flip_direct.h"
#include "tests/image/pictures.h"
#include "weft/image/error_summary.h"

namespace weft::image::test {
namespace {

constexpr double kTolerance = 1e-3;

DirectImage direct(const Image& image) {
    DirectImage result{static_cast<int>(image.width_px), static_cast<int>(image.height_px), {}};
    for (const glm::vec3& t : image.texels) result.texels.push_back({t.r, t.g, t.b});
    return result;
}

double worst_gap(const Image& a, const Image& b, float pixels_per_degree) {
    const Plane map = flip_map(a, b, pixels_per_degree);
    const std::vector<double> wanted = flip_direct(direct(a), direct(b), pixels_per_degree);
    EXPECT_EQ(map.values.size(), wanted.size());
    double worst = 0;
    for (size_t i = 0; i < wanted.size(); ++i)
        worst = std::max(worst, std::abs(wanted[i] - double{map.values[i]}));
    return worst;
}

// Returns `a` with one rectangle of its texels replaced by the texels of `b`.
Image patched(Image a, const Image& b, uint32_t left, uint32_t top, uint32_t width, uint32_t height) {
    for (uint32_t y = top; y < top + height; ++y)
        for (uint32_t x = left; x < left + width; ++x)
            a.texels[y * a.width_px + x] = b.texels[y * a.width_px + x];
    return a;
}

TEST(Flip, OfAPictureAndItselfIsZeroEverywhere) {
    const Image picture = noise(40, 23, 1);
    const Plane map = flip_map(picture, picture);
    EXPECT_EQ(map.width_px, 40u);
    EXPECT_EQ(map.height_px, 23u);
    EXPECT_EQ(*std::max_element(map.values.begin(), map.values.end()), 0);
}

// Black and white differ only in lightness: the colour distance is d = ΔL* = 100. FLIP maps d^0.7 to an error
// with two straight lines. They meet at 0.4 · 203.3^0.7, where 203.3 is the distance of green and blue, the
// largest one. 100^0.7 lies on the upper line.
TEST(Flip, OfBlackAndWhiteIsWhatThePaperNormalizesItTo) {
    const Plane map = flip_map(constant(16, 16, {0, 0, 0}), constant(16, 16, {255, 255, 255}));
    const double most = std::pow(203.3, 0.7), x = std::pow(100.0, 0.7);
    const double wanted = 0.95 + 0.05 * (x - 0.4 * most) / (0.6 * most);
    for (const float error : map.values) EXPECT_NEAR(error, wanted, kTolerance);
}

// Mid grey 119 has Y = 0.1845 and L* = 50.03, so its distance from black is 50.03. 50.03^0.7 lies on the
// lower line of FLIP's mapping, so the error is 50.03^0.7 · 0.95 / (0.4 · 203.3^0.7).
TEST(Flip, OfBlackAndGreyIsTheClosedForm) {
    const Plane map = flip_map(constant(9, 9, {0, 0, 0}), constant(9, 9, {119, 119, 119}));
    EXPECT_NEAR(map.values[40], 0.95 * std::pow(50.03, 0.7) / (0.4 * std::pow(203.3, 0.7)), kTolerance);
}

TEST(Flip, OfGreenAndBlueIsOne) {
    const Plane map = flip_map(constant(8, 8, {0, 255, 0}), constant(8, 8, {0, 0, 255}));
    for (const float error : map.values) EXPECT_NEAR(error, 1, kTolerance);
}

TEST(Flip, OfConstantsIsTheColourPipelineAlone) {
    const std::vector<std::pair<glm::ivec3, glm::ivec3>> pairs{
        {{255, 0, 0}, {0, 255, 255}}, {{128, 128, 128}, {129, 128, 128}},
        {{10, 20, 30}, {30, 20, 10}}, {{200, 180, 40}, {40, 180, 200}},
        {{0, 0, 0}, {1, 1, 1}},       {{250, 3, 97}, {13, 240, 8}}};
    for (const auto& [a, b] : pairs) {
        const auto rgb = [](glm::ivec3 c) { return Rgb{c.r / 255.0, c.g / 255.0, c.b / 255.0}; };
        const Plane map = flip_map(constant(12, 20, a), constant(12, 20, b));
        const double wanted = flip_of_constants(rgb(a), rgb(b));
        for (const float error : map.values) ASSERT_NEAR(error, wanted, kTolerance) << a.r << " " << b.r;
    }
}

TEST(Flip, OfNoiseIsWhatTheDirectSumsGive) {
    EXPECT_LT(worst_gap(noise(32, 32, 1), noise(32, 32, 2), kPixelsPerDegree), kTolerance);
    EXPECT_LT(worst_gap(noise(32, 32, 3), constant(32, 32, {127, 127, 127}), kPixelsPerDegree), kTolerance);
}

// Three pairs combine noise with a constant colour, to test features and smooth areas. The pictures of the
// other two pairs are smaller than the filters.
TEST(Flip, OfPartsIsWhatTheDirectSumsGive) {
    const Image a = noise(32, 32, 5), grey = constant(32, 32, {90, 120, 150});
    EXPECT_LT(worst_gap(grey, patched(grey, a, 3, 20, 9, 7), kPixelsPerDegree), kTolerance);
    EXPECT_LT(worst_gap(a, patched(a, grey, 25, 0, 7, 32), kPixelsPerDegree), kTolerance);
    EXPECT_LT(worst_gap(noise(17, 3, 6), noise(17, 3, 7), kPixelsPerDegree), kTolerance);
    EXPECT_LT(worst_gap(noise(1, 1, 6), noise(1, 1, 7), kPixelsPerDegree), kTolerance);
    EXPECT_LT(worst_gap(a, patched(a, grey, 8, 8, 16, 16), 30), kTolerance);
}

TEST(Flip, IsTheSameEitherWay) {
    const Image a = noise(32, 20, 8), b = noise(32, 20, 9);
    EXPECT_EQ(flip_map(a, b).values, flip_map(b, a).values);
}

// If only one of the pictures has an edge, FLIP's error is larger than that of the colour difference alone.
TEST(Flip, SeesThinLinesThatComeAndGo) {
    const Image grey = constant(41, 41, {128, 128, 128});
    const Image line = patched(grey, constant(41, 41, {255, 255, 255}), 20, 0, 1, 41);
    const Plane map = flip_map(grey, line);
    EXPECT_GT(map.values[20 * 41 + 20], 0.3f);
    EXPECT_LT(map.values[20 * 41 + 5], 0.01f);
}

// Linear values are clamped to 0..1 before the comparison: values above 1 count as white and negative values
// as black.
TEST(Flip, OfLinearPicturesClampsThem) {
    Image bright = constant(8, 8, {0, 0, 0}), white = bright, dark = bright;
    for (Image* image : {&bright, &white, &dark}) image->encoding = Encoding::linear;
    bright.texels.assign(64, glm::vec3(7, 1e30f, HUGE_VALF));
    white.texels.assign(64, glm::vec3(1));
    dark.texels.assign(64, glm::vec3(-3, 0, -HUGE_VALF));
    EXPECT_EQ(flip_map(bright, white).values[9], 0);
    EXPECT_NEAR(flip_map(bright, dark).values[9], flip_of_constants({0, 0, 0}, {1, 1, 1}), kTolerance);
}

TEST(FlipKernels, KeepConstantsAndSeeNoFeaturesInThem) {
    for (const float ppd : {10.0f, 67.0f, 120.0f}) {
        for (const auto& channel : sensitivity_kernels(ppd)) {
            double weight = 0;
            for (const WeightedGaussian& gaussian : channel) weight += gaussian.weight;
            EXPECT_NEAR(weight, 1, 1e-6);
        }
        const FeatureKernels kernels = feature_kernels(ppd);
        for (const auto* taps : {&kernels.edge, &kernels.point}) {
            double sum = 0, size = 0;
            for (const float tap : *taps) sum += tap, size += std::abs(tap);
            EXPECT_NEAR(sum, 0, 1e-6);
            EXPECT_NEAR(size, 2, 1e-6);
        }
    }
}

TEST(OpponentColor, GoesThereAndBack) {
    for (const glm::vec3 rgb :
         {glm::vec3(0), glm::vec3(1), glm::vec3(1, 0, 0), glm::vec3(0.2f, 0.9f, 0.4f)}) {
        const glm::vec3 back = ycxcz_to_linear(linear_to_ycxcz(rgb));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(back[c], rgb[c], 2e-6);
    }
    EXPECT_NEAR(linear_to_ycxcz(glm::vec3(1)).x, 100, 1e-4);
    EXPECT_NEAR(linear_to_ycxcz(glm::vec3(0)).x, -16, 1e-4);
    EXPECT_NEAR(linear_to_ycxcz(glm::vec3(0.5f)).y, 0, 1e-4);
}

TEST(ErrorSummary, CountsByHand) {
    const ErrorSummary summary = summarize({5, 1, {0.0f, 0.5f, 0.25f, 0.0f, 0.25f}});
    EXPECT_DOUBLE_EQ(summary.mean, 0.2);
    EXPECT_DOUBLE_EQ(summary.median, 0.25);
    EXPECT_DOUBLE_EQ(summary.max, 0.5);
    EXPECT_EQ(summary.weighted_quartiles, (std::array<double, 3>{0.25, 0.25, 0.5}));
    EXPECT_EQ(summarize({2, 1, {0, 0}}).weighted_quartiles, (std::array<double, 3>{0, 0, 0}));
}

// Large pictures are compared in bands of about 2^19 texels. Texels near the border between two bands must
// have the same values as in a comparison of only the rows around the border, which needs a single band.
TEST(Flip, OfBandsIsThatOfTheWholePicture) {
    constexpr uint32_t kWidth = 32, kHeight = (1 << 19) / kWidth + 300, kMeet = (1 << 19) / kWidth;
    const Image a = noise(kWidth, kHeight, 1), b = noise(kWidth, kHeight, 2);
    constexpr uint32_t kTop = kMeet - 120, kRows = 240;
    const auto part_of = [&](const Image& whole) {
        const auto begin = whole.texels.begin() + kTop * kWidth;
        return Image{kWidth, kRows, whole.encoding, {begin, begin + kRows * kWidth}};
    };
    const Plane whole = flip_map(a, b), part = flip_map(part_of(a), part_of(b));
    ASSERT_EQ(whole.values.size(), a.texels.size());
    for (uint32_t i = 60 * kWidth; i < (kRows - 60) * kWidth; ++i)
        ASSERT_EQ(whole.values[kTop * kWidth + i], part.values[i]) << "row " << kTop + i / kWidth;
    EXPECT_LE(flip_band_bytes(16384, 16384), uint64_t{512} << 20);
}

}  // namespace
}  // namespace weft::image::test

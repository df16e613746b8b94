// Purpose: compares PSNR and the largest difference of two pictures with values computed by hand.
#include "weft/image/channel_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/image/pictures.h"

namespace weft::image::test {
namespace {

Image raw(std::vector<glm::vec3> texels) {
    return {static_cast<uint32_t>(texels.size()), 1, Encoding::linear, std::move(texels)};
}

TEST(Psnr, IsInfiniteForTheSame) {
    const Image picture = noise(7, 5, 1);
    EXPECT_EQ(psnr_db(picture, picture), std::numeric_limits<double>::infinity());
}

// Three cases, one for each assertion:
// - Every channel differs by 1: 20 log10 255 = 48.1308 dB.
// - One of three channels differs by 16, in one of four texels. The mean square error is 16² / 12, and
//   10 log10(255² · 12 / 16²) = 34.8399 dB.
// - Black and white: 0 dB.
TEST(Psnr, IsWhatAHandComputes) {
    EXPECT_NEAR(psnr_db(constant(8, 8, {9, 99, 199}), constant(8, 8, {10, 98, 200})), 48.1308, 0.01);
    Image changed = constant(4, 1, {50, 60, 70});
    changed.texels[2].g += 16 / 255.0f;
    EXPECT_NEAR(psnr_db(constant(4, 1, {50, 60, 70}), changed), 34.8399, 0.01);
    EXPECT_NEAR(psnr_db(constant(3, 3, {0, 0, 0}), constant(3, 3, {255, 255, 255})), 0, 1e-9);
}

// PSNR compares display values of 0 to 255. The linear value 0.2159 is the display value 128. The linear
// values 1 and 2 are both the display value 255, because linear values above 1 are clamped.
TEST(Psnr, OfLinearPicturesIsOverDisplayValues) {
    EXPECT_EQ(psnr_db(raw({glm::vec3(2)}), raw({glm::vec3(1)})), std::numeric_limits<double>::infinity());
    EXPECT_NEAR(psnr_db(raw({glm::vec3(0.2159f)}), raw({glm::vec3(0)})), 20 * std::log10(255.0 / 128), 0.01);
}

TEST(LargestDifference, CountsStepsOfDisplayValues) {
    Image changed = constant(4, 4, {50, 60, 70});
    changed.texels[5] = {51 / 255.0f, 43 / 255.0f, 72 / 255.0f};
    EXPECT_EQ(largest_difference(constant(4, 4, {50, 60, 70}), changed), 17);
    EXPECT_FLOAT_EQ(difference_map(constant(4, 4, {50, 60, 70}), changed).values[5], 17 / 255.0f);
    EXPECT_EQ(difference_map(constant(4, 4, {50, 60, 70}), changed).values[6], 0);
}

TEST(LargestDifference, IsRawForLinearPicturesAndOfStepsForOneOfEach) {
    EXPECT_FLOAT_EQ(static_cast<float>(largest_difference(raw({{1, 5, 900}}), raw({{1, 7.5f, 899}}))), 2.5f);
    EXPECT_EQ(largest_difference(raw({{1, 5, 0}}), constant(1, 1, {255, 254, 0})), 1);
}

TEST(LargestDifference, TakesNaNForAValueOfItsOwn) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(largest_difference(raw({{kNan, kInfinity, 1}}), raw({{kNan, kInfinity, 1}})), 0);
    EXPECT_EQ(largest_difference(raw({{kNan, 0, 1}}), raw({{5, 0, 1}})), kInfinity);
    EXPECT_EQ(largest_difference(raw({{0, 5, 1}}), raw({{0, kNan, 1}})), kInfinity);
}

TEST(ChannelDifference, IsTheSameEitherWay) {
    const Image a = noise(13, 9, 3), b = noise(13, 9, 4);
    EXPECT_EQ(psnr_db(a, b), psnr_db(b, a));
    EXPECT_EQ(largest_difference(a, b), largest_difference(b, a));
    EXPECT_EQ(difference_map(a, b).values, difference_map(b, a).values);
}

}  // namespace
}  // namespace weft::image::test

#include "weft/image/heat_map.h"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::image::test {
namespace {

uint32_t rgb_of(float error) {
    uint32_t rgb = 0;
    for (size_t c = 0; c < 3; ++c) rgb = rgb << 8 | std::to_integer<uint32_t>(magma(error)[c]);
    return rgb;
}

TEST(HeatMap, HasMagmasColoursAtItsEndsAndBetween) {
    EXPECT_EQ(rgb_of(0), 0x000004u);
    EXPECT_EQ(rgb_of(1), 0xfcfdbfu);
    EXPECT_EQ(rgb_of(4 / 9.0f), 0x9f2f7fu);
    EXPECT_EQ(rgb_of(0.5f), 0xb63878u) << "half way from 9f2f7f to cd4071";
    EXPECT_EQ(rgb_of(-1), rgb_of(0));
    EXPECT_EQ(rgb_of(HUGE_VALF), rgb_of(1));
    EXPECT_EQ(rgb_of(NAN), rgb_of(1));
}

TEST(HeatMap, GetsLighterAllTheWay) {
    float before = -1;
    for (int i = 0; i <= 200; ++i) {
        const auto color = magma(static_cast<float>(i) / 200);
        const auto part = [&](size_t c) { return static_cast<float>(std::to_integer<int>(color[c])); };
        const float luma = 0.2126f * part(0) + 0.7152f * part(1) + 0.0722f * part(2);
        EXPECT_GE(luma, before) << i;
        before = luma;
    }
}

TEST(HeatMap, HasFourBytesATexel) {
    const std::vector<std::byte> rgba = heat_map({3, 2, {0, 0, 0, 1, 1, 1}});
    ASSERT_EQ(rgba.size(), 24u);
    EXPECT_EQ(rgba[3], std::byte{255});
    EXPECT_EQ(rgba[12], std::byte{0xfc});
}

}  // namespace
}  // namespace weft::image::test

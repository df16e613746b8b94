#include "scene/pictures/mip_chain.h"

#include <gtest/gtest.h>

namespace weft::scene::test {
namespace {

using Bytes = std::vector<uint8_t>;

Bytes repeat(std::initializer_list<uint8_t> texel, size_t count) {
    Bytes out;
    for (size_t i = 0; i < count; ++i) out.insert(out.end(), texel);
    return out;
}

TEST(MipChain, GoesDownToOneTexel) {
    const auto mips = build_mip_chain(5, 3, Bytes(60, 9), {});
    ASSERT_EQ(mips.size(), 3u);
    EXPECT_EQ(mips[1].size(), 2u * 1 * 4);
    EXPECT_EQ(mips[2], Bytes(4, 9));
}

TEST(MipChain, AveragesLinearDataAsItIs) {
    // A picture of 4 × 4 texels whose columns have the values 0, 100, 200, 40. The average of the first two
    // columns is 50, that of the last two columns is 120, and that of the whole picture is 85.
    Bytes rgba;
    for (int y = 0; y < 4; ++y) {
        for (const uint8_t value : {0, 100, 200, 40}) rgba.insert(rgba.end(), {value, value, value, 255});
    }
    const auto mips = build_mip_chain(4, 4, rgba, {TexelMeaning::linear_data});
    ASSERT_EQ(mips.size(), 3u);
    EXPECT_EQ(mips[0], rgba);
    EXPECT_EQ(mips[1][0], 50);
    EXPECT_EQ(mips[1][4], 120);
    EXPECT_EQ(mips[2], (Bytes{85, 85, 85, 255}));
}

TEST(MipChain, AveragesColourInLinearLight) {
    // Half black and half white gives half the light, which is 188 in sRGB and not 128. Alpha is averaged
    // linearly.
    const Bytes rgba{0, 0, 0, 0, 255, 255, 255, 255};
    EXPECT_EQ(build_mip_chain(2, 1, rgba, {TexelMeaning::srgb_color})[1], (Bytes{188, 188, 188, 128}));
}

TEST(MipChain, WeighsOddSizesByArea) {
    // Three texels become one texel. Each of the three contributes a third.
    const Bytes rgba{30, 0, 0, 255, 60, 0, 0, 255, 90, 0, 0, 255};
    EXPECT_EQ(build_mip_chain(3, 1, rgba, {TexelMeaning::linear_data})[1][0], 60);
    // Five texels a b c d e become two texels. The first texel is (a + b + c/2) / 2.5.
    const Bytes five{100, 0, 0, 255, 50, 0, 0, 255, 20, 0, 0, 255, 0, 0, 0, 255, 200, 0, 0, 255};
    const auto mips = build_mip_chain(5, 1, five, {TexelMeaning::linear_data});
    EXPECT_EQ(mips[1][0], 64);
    EXPECT_EQ(mips[1][4], 84);
}

TEST(MipChain, NormalsKeepTheirLength) {
    // The average of the normals +x and +z is the direction halfway between them, with length 1.
    const Bytes rgba{255, 128, 128, 255, 128, 128, 255, 255};
    const Bytes texel = build_mip_chain(2, 1, rgba, {TexelMeaning::normal})[1];
    EXPECT_NEAR(texel[0], 218, 1);
    EXPECT_NEAR(texel[1], 128, 1);
    EXPECT_NEAR(texel[2], 218, 1);
}

TEST(MipChain, MasksKeepTheirCoverage) {
    // One texel in four has an alpha of 240 or 255, the others have 0. In mip 1 without a correction, the
    // average alpha of four texels is below the cutoff of 0.5 everywhere, so all texels would vanish. If
    // build_mip_chain() keeps the coverage, about a quarter of the texels in mip 1 must still pass.
    Bytes rgba = repeat({255, 255, 255, 0}, 256);
    for (size_t y = 0; y < 16; y += 2) {
        for (size_t x = 0; x < 16; x += 2) rgba[(y * 16 + x) * 4 + 3] = (x + y) % 8 == 0 ? 255 : 240;
    }
    const auto plain = build_mip_chain(16, 16, rgba, {TexelMeaning::srgb_color});
    const auto kept = build_mip_chain(16, 16, rgba, {TexelMeaning::srgb_color, 0.5f});
    const auto passing = [](const Bytes& mip) {
        size_t count = 0;
        for (size_t i = 3; i < mip.size(); i += 4) count += mip[i] >= 128;
        return static_cast<double>(count) / (static_cast<double>(mip.size()) / 4);
    };
    EXPECT_DOUBLE_EQ(passing(plain[1]), 0);
    EXPECT_NEAR(passing(kept[1]), 0.25, 0.1);
}

TEST(MipChain, TheSrgbCurveAndItsInverseMeet) {
    for (int i = 0; i <= 255; ++i) {
        const float value = static_cast<float>(i) / 255.0f;
        EXPECT_NEAR(linear_to_srgb(srgb_to_linear(value)), value, 1e-5f);
    }
    EXPECT_NEAR(srgb_to_linear(0.5f), 0.2140411f, 1e-6f);
}

}  // namespace
}  // namespace weft::scene::test

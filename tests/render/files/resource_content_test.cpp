// Purpose: tests how the content of files becomes texels: every colour format against the decoder that the
// program uses for pictures, mips against a brute-force box filter, and damaged files.
#include "weft/load/resource_content.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "load/picture_file.h"
#include "load/texel_encode.h"
#include "tests/render/files/picture_bytes.h"
#include "weft/render/texels.h"

namespace weft::test {
namespace {

std::vector<glm::vec4> random_values(size_t count, float least, float most) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> any(least, most);
    std::vector<glm::vec4> values;
    for (size_t i = 0; i < count; ++i)
        values.emplace_back(any(random), any(random), any(random), any(random));
    return values;
}

// The largest difference that rounding to the format may cause, for values in [0, 1].
float half_step(const FormatInfo& info) {
    const uint32_t bits = 8u * info.bytes_per_texel / info.components;
    const std::string_view name = info.name;
    if (name == "b10g11r11f" || name == "rgb9e5") return 1.0f / 64;
    if (name == "rgb10a2") return 0.5f / 3;  // The two bits of alpha.
    if (name.ends_with("32f")) return 0;
    if (name.ends_with("16f")) return 1.0f / 2048;
    const float steps = std::exp2(static_cast<float>(name.ends_with("snorm") ? bits - 1 : bits)) - 1;
    return 0.5001f / steps;
}

TEST(ResourceContent, EveryColourFormatKeepsTheValuesUpToRounding) {
    const std::vector<glm::vec4> values = random_values(64, 0, 1);
    size_t formats = 0;
    for (const std::string& name : format_names()) {
        const FormatInfo& info = format_info(*format_from_name(name));
        if (info.depth || info.stencil || info.numeric != NumericClass::float_like || info.srgb) continue;
        ++formats;
        const std::vector<std::byte> bytes = encode_texels(info.format, values, {});
        ASSERT_EQ(bytes.size(), values.size() * info.bytes_per_texel) << name;
        const std::vector<glm::vec4> found = render::decode_texels(info.format, bytes);
        for (size_t i = 0; i < values.size(); ++i)
            for (int c = 0; c < info.components; ++c)
                EXPECT_LE(std::abs(found[i][c] - values[i][c]), half_step(info)) << name << " " << i;
    }
    EXPECT_GE(formats, 20u);
}

TEST(ResourceContent, IntegerFormatsGetTheStoredNumbers) {
    const std::vector<glm::vec4> values{glm::vec4(0, 1, 200, 255) / 255.0f};
    const auto stored = [&](Format format) {
        return render::decode_texels(format, encode_texels(format, values, {255, false})).at(0);
    };
    EXPECT_EQ(stored(Format::rgba8u), glm::vec4(0, 1, 200, 255));
    EXPECT_EQ(stored(Format::rgba16u), glm::vec4(0, 1, 200, 255));
    EXPECT_EQ(stored(Format::rgba32i), glm::vec4(0, 1, 200, 255));
    const std::vector<glm::vec4> large{glm::vec4(-5, 70'000, NAN, 3.6f)};
    EXPECT_EQ(render::decode_texels(Format::rgba16u, encode_texels(Format::rgba16u, large, {})).at(0),
              glm::vec4(0, 65'535, 0, 4));
}

TEST(ResourceContent, SrgbFormatsStoreTheBytesOfAPng) {
    std::vector<glm::vec4> values;
    for (int i = 0; i < 256; ++i) values.emplace_back(glm::vec4(static_cast<float>(i) / 255.0f));
    const std::vector<std::byte> bytes = encode_texels(Format::rgba8_srgb, values, {255, true});
    for (size_t i = 0; i < 256; ++i) EXPECT_EQ(static_cast<size_t>(bytes[4 * i]), i);
}

TEST(ResourceContent, MipsAreMeansOfTheCoveredArea) {
    for (const glm::uvec2 size : {glm::uvec2(8, 4), glm::uvec2(5, 7), glm::uvec2(1, 6), glm::uvec2(3, 1)}) {
        const std::vector<glm::vec4> values = random_values(size_t{size.x} * size.y, -3, 3);
        const std::vector<glm::vec4> found = halve(values, size.x, size.y);
        const glm::uvec2 half = glm::max(size / 2u, glm::uvec2(1));
        ASSERT_EQ(found.size(), size_t{half.x} * half.y);
        // The reference samples each texel of the mip at points so dense that they divide all texels evenly.
        const uint32_t dense = 12;
        for (uint32_t y = 0; y < half.y; ++y) {
            for (uint32_t x = 0; x < half.x; ++x) {
                glm::dvec4 sum(0);
                const glm::uvec2 points = size * dense / half;
                for (uint32_t v = 0; v < points.y; ++v)
                    for (uint32_t u = 0; u < points.x; ++u) {
                        const glm::dvec2 at =
                            (glm::dvec2(x * points.x + u, y * points.y + v) + 0.5) / double{dense};
                        sum += values[static_cast<size_t>(at.y) * size.x + static_cast<size_t>(at.x)];
                    }
                const glm::dvec4 wanted = sum / (double{1} * points.x * points.y);
                EXPECT_LE(glm::length(glm::dvec4(found[y * half.x + x]) - wanted), 1e-5) << x << " " << y;
            }
        }
    }
}

TEST(ResourceContent, PicturesOfEachKindAreDecoded) {
    const PictureTexels grey = decode_picture(plain_png(2, 1, 8, 1, {0, 51}));
    EXPECT_EQ(grey.values.at(1), glm::vec4(0.2f, 0.2f, 0.2f, 1)) << grey.fault;
    EXPECT_EQ(grey.whole, 255);
    const PictureTexels wide = decode_picture(plain_png(1, 2, 16, 4, {1, 2, 3, 4, 65535, 258, 0, 77}));
    ASSERT_EQ(wide.values.size(), 2u) << wide.fault;
    EXPECT_EQ(glm::round(wide.values[0] * 65535.0f), glm::vec4(1, 2, 3, 4));
    EXPECT_EQ(glm::round(wide.values[1] * 65535.0f), glm::vec4(65535, 258, 0, 77));
    const PictureTexels pfm = decode_picture(plain_pfm(1, 2, {{1, 2, 3}, {-4, 5e9f, 6}}));
    ASSERT_EQ(pfm.values.size(), 2u) << pfm.fault;
    EXPECT_EQ(pfm.values[0], glm::vec4(1, 2, 3, 1)) << "row 0 is the top row";
    EXPECT_EQ(pfm.values[1], glm::vec4(-4, 5e9f, 6, 1));
    const std::string hdr =
        "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n" + std::string("\x80\x40\x20\x81", 4);
    const PictureTexels radiance = decode_picture(hdr);
    ASSERT_EQ(radiance.values.size(), 1u) << radiance.fault;
    EXPECT_NEAR(radiance.values[0].r, 1, 0.01);
    EXPECT_NEAR(radiance.values[0].b, 0.25, 0.01);
}

TEST(ResourceContent, DamagedPicturesHaveAFault) {
    const std::string png = plain_png(4, 4, 8, 4, std::vector<uint32_t>(64, 9));
    EXPECT_FALSE(read_picture_header(png.substr(0, 20)).fault.empty());
    EXPECT_FALSE(decode_picture(png.substr(0, png.size() - 30)).fault.empty());
    EXPECT_FALSE(read_picture_header("PF\n-3 2\n-1\n").fault.empty());
    EXPECT_FALSE(read_picture_header("PF\n99999999999 2\n-1\n").fault.empty());
    EXPECT_FALSE(decode_picture("PF\n3 2\n-1\nshort").fault.empty());
    EXPECT_FALSE(read_picture_header("#?RADIANCE\n").fault.empty());
    EXPECT_FALSE(read_picture_header("\x76\x2f\x31\x01 nothing").fault.empty());
    EXPECT_EQ(read_picture_header("texels").width_px, 0u);
    EXPECT_TRUE(read_picture_header("texels").fault.empty()) << "the bytes are texels";
}

}  // namespace
}  // namespace weft::test

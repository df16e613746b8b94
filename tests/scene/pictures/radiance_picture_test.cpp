// Purpose: tests the decoder of Radiance pictures with uncompressed (flat) rows, run-length encoded rows and
// broken files, and the loading of such a picture as an environment.
#include "scene/pictures/radiance_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "scene/pictures/load_environment.h"

namespace weft::scene {
namespace {

std::vector<uint8_t> picture_bytes(const std::string& text) {
    return {text.begin(), text.end()};
}

std::string header(const std::string& size, const std::string& more = "") {
    return "#?RADIANCE\n# a comment\n" + more + "FORMAT=32-bit_rle_rgbe\n\n" + size + "\n";
}

std::string row_start(uint8_t width) {
    return {'\2', '\2', '\0', char(width)};
}

// Returns a run-length encoded row of ten equal texels. Each channel has one run that repeats its value four
// times, then six values that are stored one by one.
std::string coded_row() {
    std::string row = row_start(10);
    for (const char value : {char(128), char(64), char(32), char(130)}) {
        row += char(128 + 4);
        row += value;
        row += char(6);
        row += std::string(6, value);
    }
    return row;
}

RadiancePicture decoded(const std::string& text) {
    const std::vector<uint8_t> bytes = picture_bytes(text);
    const RadianceHeader head = read_radiance_header(bytes);
    if (!head.error.empty()) return {{}, head.error};
    return decode_radiance(head, bytes);
}

TEST(RadiancePicture, ReadsCodedRows) {
    const RadiancePicture picture = decoded(header("-Y 2 +X 10") + coded_row() + coded_row());
    ASSERT_EQ(picture.error, "");
    ASSERT_EQ(picture.texels.size(), 20u);
    // Expected red: the mantissa 128 with the exponent 130 is 128 · 2^(130 − 136) = 2.
    for (const glm::vec3& texel : picture.texels) EXPECT_EQ(texel, glm::vec3(2, 1, 0.5f));
}

TEST(RadiancePicture, ReadsFlatRowsAndBlack) {
    const std::string texels{char(255), char(128), 1, char(136), 77, 77, 77, 0};
    const RadiancePicture picture = decoded(header("-Y 1 +X 2") + texels);
    ASSERT_EQ(picture.error, "");
    EXPECT_EQ(picture.texels.at(0), glm::vec3(255, 128, 1));
    EXPECT_EQ(picture.texels.at(1), glm::vec3(0));
}

TEST(RadiancePicture, DividesByExposure) {
    const RadiancePicture picture =
        decoded(header("-Y 1 +X 1", "EXPOSURE=2\nEXPOSURE= 4.0\n") + std::string{16, 8, 8, char(136)});
    ASSERT_EQ(picture.error, "");
    EXPECT_EQ(picture.texels.at(0), glm::vec3(2, 1, 1));
}

struct Broken {
    const char* name;
    std::string text;
    const char* said;
};

class BrokenRadiance : public ::testing::TestWithParam<Broken> {};

TEST_P(BrokenRadiance, IsNamed) {
    const RadiancePicture picture = decoded(GetParam().text);
    EXPECT_TRUE(picture.texels.empty());
    EXPECT_NE(picture.error.find(GetParam().said), std::string::npos) << picture.error;
}

INSTANTIATE_TEST_SUITE_P(
    All, BrokenRadiance,
    ::testing::Values(Broken{"Empty", "", "#?RADIANCE"}, Broken{"Png", "\x89PNG\r\n", "#?RADIANCE"},
                      Broken{"NoEndOfHeader", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n", "is truncated"},
                      Broken{"Xyz", "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n1234", "FORMAT"},
                      Broken{"Turned", header("+Y 1 +X 1") + "1234", "-Y height +X width"},
                      Broken{"NoSize", header("-Y 0 +X 8") + "1234", "-Y height +X width"},
                      Broken{"HugeNumber", header("-Y 99999999999 +X 8"), "-Y height +X width"},
                      Broken{"CutFlat", header("-Y 2 +X 2") + "0123456789", "ends in row 2 of 2"},
                      // With this truncated input, the decoder of the library stb never returns.
                      Broken{"CutCoded", header("-Y 2 +X 10") + coded_row() + row_start(10), "row 2 of 2"},
                      Broken{"NoCount", header("-Y 1 +X 10") + row_start(10) + std::string(40, '\0'),
                             "broken in row 1"},
                      Broken{"TooLongARun", header("-Y 1 +X 10") + row_start(10) + char(128 + 11) + "x",
                             "broken in row 1"}),
    [](const auto& row) { return std::string(row.param.name); });

class EnvironmentFile : public ::testing::Test {
 protected:
    EnvironmentFile() : path_(std::filesystem::temp_directory_path() / "weft_environment_test.hdr") {}
    ~EnvironmentFile() override { std::filesystem::remove(path_); }
    Result<Environment> load(const std::string& text) {
        std::ofstream(path_, std::ios::binary) << text;
        return load_environment(path_);
    }
    std::filesystem::path path_;
};

TEST_F(EnvironmentFile, IsReadWhole) {
    const Result<Environment> environment = load(header("-Y 2 +X 10") + coded_row() + coded_row());
    ASSERT_TRUE(environment);
    EXPECT_EQ(environment->mips.size(), 4u);
    EXPECT_EQ(environment->name, "weft_environment_test");
    EXPECT_NEAR(environment->irradiance_over_pi[0].r, 2, 1e-5);
}

TEST_F(EnvironmentFile, ItsSizeIsJudgedBeforeItIsRead) {
    const Result<Environment> environment = load(header("-Y 16000 +X 16000"));
    ASSERT_FALSE(environment);
    EXPECT_EQ(environment.errors().front().code, "S181");
    EXPECT_EQ(load(header("-Y 1 +X 20000")).errors().front().code, "S181");
    EXPECT_EQ(load(header("-Y 4 +X 4")).errors().front().code, "S180");
}

}  // namespace
}  // namespace weft::scene

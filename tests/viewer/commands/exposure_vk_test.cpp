// Tests --exposure: it fixes the exposure of graphs with automatic exposure, and sets that of other graphs.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/viewer/commands/render_stats.h"

namespace weft::test {
namespace {

std::string picture_with(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"builtin:spheres", "--size", "64x36"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return render_stats(std::move(arguments)).value("output_sha256", std::string());
}

TEST(ExposureOption, FixesTheExposure) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    // The exposure of the scene is −9.6 EV.
    const std::string automatic = picture_with({}), fixed = picture_with({"--exposure", "-9.6"});
    EXPECT_EQ(fixed, picture_with({"--param", "autoExposure=0"}));
    EXPECT_NE(fixed, automatic);
    EXPECT_EQ(automatic, picture_with({"--exposure", "-9.6", "--param", "autoExposure=1"}))
        << "--param has the last word";
}

TEST(ExposureOption, FixesTheExposureOfAModuleWithAName) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const std::string eye = WEFT_SOURCE_DIR "/tests/render/exposure/eye.json",
                      forward = WEFT_SOURCE_DIR "/graphs/forward.json";
    EXPECT_EQ(picture_with({"--graph", eye, "--exposure", "-9.6"}),
              picture_with({"--graph", forward, "--exposure", "-9.6"}));
    EXPECT_EQ(picture_with({"--graph", eye}),
              picture_with({"--graph", forward, "--param", "compensation=1"}));
}

// A picture of one brightness surrounds a scene with the exposure −9.6 EV: 32,768 cd/m² are 8 stops above
// middle grey, 524,288 cd/m² are 12 stops above it.
TEST(ExposureOption, EnvironmentsThatDoNotFitGiveAWarning) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder folder;
    const auto warning = [&](int exponent, std::vector<std::string> more) {
        std::ofstream file(folder / "env.hdr", std::ios::binary);
        file << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n";
        for (int i = 0; i < 2; ++i) file << '\x80' << '\x80' << '\x80' << static_cast<char>(exponent);
        file.close();
        std::vector<std::string> words{"render", "builtin:spheres",  "--size", "16x9",
                                       "--env",  folder / "env.hdr", "-o",     folder / "a.png"};
        words.insert(words.end(), more.begin(), more.end());
        const RunResult run = run_weft(words);
        EXPECT_EQ(run.exit_code, 0) << run.text();
        return run.err.find("warning[S182]") != std::string::npos;
    };
    EXPECT_TRUE(warning(144, {"--exposure", "-9.6"}));
    EXPECT_FALSE(warning(144, {})) << "the automatic exposure adapts";
    EXPECT_TRUE(warning(148, {})) << "half floats cannot store the picture";
    EXPECT_FALSE(warning(136, {"--exposure", "-9.6"}));
}

TEST(ExposureOption, WorksWithGraphsWithoutTheModule) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const std::string graph = WEFT_SOURCE_DIR "/tests/render/exposure/plain.json";
    EXPECT_EQ(picture_with({"--graph", graph}), picture_with({"--graph", graph, "--exposure", "-9.6"}));
    EXPECT_NE(picture_with({"--graph", graph}), picture_with({"--graph", graph, "--exposure", "-8"}));
}

}  // namespace
}  // namespace weft::test

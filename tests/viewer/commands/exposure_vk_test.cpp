// Tests --exposure: it fixes the exposure of graphs with automatic exposure, and sets that of other graphs.
#include <gtest/gtest.h>

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
    EXPECT_NE(fixed, picture_with({"--exposure", "-9"}));
    EXPECT_EQ(automatic, picture_with({"--exposure", "-9.6", "--param", "autoExposure=1"}))
        << "--param has the last word";
}

TEST(ExposureOption, WorksWithGraphsWithoutTheModule) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const std::string graph = WEFT_SOURCE_DIR "/docs/examples/ink.json";
    EXPECT_EQ(picture_with({"--graph", graph}), picture_with({"--graph", graph, "--exposure", "-9.6"}));
    EXPECT_NE(picture_with({"--graph", graph}), picture_with({"--graph", graph, "--exposure", "-8"}));
}

}  // namespace
}  // namespace weft::test

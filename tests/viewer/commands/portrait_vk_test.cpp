// Tests that a picture in portrait format shows the full width of a built-in scene. This does not apply to a
// camera that is named on the command line, or to a camera inside the scene.
#include <gtest/gtest.h>

#include "tests/viewer/commands/render_stats.h"
#include "tests/viewer/pictures/pfm_image.h"

namespace weft::test {
namespace {

class Portrait : public testing::Test {
 protected:
    void SetUp() override {
        if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    }
    static std::string picture(const char* scene, const char* size, const std::vector<std::string>& camera) {
        std::vector<std::string> arguments{scene, "--size", size};
        arguments.insert(arguments.end(), camera.begin(), camera.end());
        return render_stats(std::move(arguments)).value("output_sha256", std::string());
    }
};

TEST_F(Portrait, HoldsAllOfTheSpheres) {
    const ScratchFolder folder;
    const auto red_at_the_sides = [&](const std::vector<std::string>& camera) {
        std::vector<std::string> arguments{"render",     "builtin:spheres", "--size", "36x64",
                                           "--resource", "albedo",          "-o",     folder / "albedo.pfm"};
        arguments.insert(arguments.end(), camera.begin(), camera.end());
        const RunResult run = run_weft(arguments);
        EXPECT_EQ(run.exit_code, 0) << run.text();
        const std::optional<PfmImage> albedo = read_pfm(folder / "albedo.pfm");
        size_t red = 0;
        for (uint32_t y = 0; albedo && y < albedo->height_px; ++y)
            for (const uint32_t x : {0u, albedo->width_px - 1})
                if (albedo->at(x, y)[0] > 1.2f * albedo->at(x, y)[2]) ++red;
        return albedo ? red : SIZE_MAX;
    };
    EXPECT_EQ(red_at_the_sides({}), 0u) << "the ground is grey and spheres are red";
    EXPECT_GT(red_at_the_sides({"--camera", "overview"}), 0u) << "a named camera keeps its field of view";
}

TEST_F(Portrait, IsEachPictureThatIsHigherThanWideAndNoOther) {
    for (const char* size : {"32x32", "40x32"})
        EXPECT_EQ(picture("builtin:spheres", size, {}),
                  picture("builtin:spheres", size, {"--camera", "overview"}))
            << size;
    EXPECT_NE(picture("builtin:spheres", "31x32", {}),
              picture("builtin:spheres", "31x32", {"--camera", "overview"}));
}

TEST_F(Portrait, OfACameraInsideTheSceneKeepsItsFieldOfView) {
    EXPECT_NE(picture("builtin:cornell", "36x64", {}),
              picture("builtin:cornell", "36x64", {"--camera", "front"}))
        << "this one stands outside";
    EXPECT_EQ(picture("builtin:atrium", "36x64", {}),
              picture("builtin:atrium", "36x64", {"--camera", "court"}));
}

}  // namespace
}  // namespace weft::test

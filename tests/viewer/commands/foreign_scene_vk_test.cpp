// Renders glTF files that other programs could have made, as a user does, and checks the pixels and messages.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/viewer/gltf_file.h"
#include "tests/viewer/pictures/pfm_image.h"
#include "tests/viewer/program.h"

namespace weft::test {
namespace {

class ForeignScene : public testing::TestWithParam<const char*> {
 protected:
    void SetUp() override {
        if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    }
    [[nodiscard]] static std::string graph() {
        return std::string(WEFT_SOURCE_DIR "/graphs/") + GetParam() + ".json";
    }
    [[nodiscard]] RunResult render(const std::string& gltf, std::vector<std::string> more) const {
        folder_.write("scene.gltf", gltf);
        std::vector<std::string> arguments{"render", "scene.gltf", "--graph", graph(), "--validate"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_weft(arguments, {}, folder_.path());
    }

    ScratchFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(Graphs, ForeignScene, testing::Values("deferred", "forward"),
                         [](const auto& tested) { return std::string(tested.param); });

// A point on the ground (y = 0), in metres.
struct Ground {
    double x, z;
};
// Returns the point where the ray through the centre of pixel (i, j) meets the ground. The constants are
// those of the camera of square_gltf(): the vertical field of view is 0.8 rad, the position is (0, 1, 3), and
// the x component of the rotation quaternion is -0.1564345.
Ground ground_at(uint32_t i, uint32_t j, uint32_t width_px, uint32_t height_px) {
    const double half = std::tan(0.4), turn = 2 * std::asin(-0.1564345);
    const double right = (2 * (i + 0.5) / width_px - 1) * half * width_px / height_px;
    const double up = (1 - 2 * (j + 0.5) / height_px) * half;
    const double y = up * std::cos(turn) + std::sin(turn), z = up * std::sin(turn) - std::cos(turn);
    return {-right / y, 3 - z / y};
}

TEST_P(ForeignScene, VertexColoursOfAnUnlitSquareAreItsPixels) {
    // The file uses the positions as vertex colours too. The loader clamps negative colours to 0 and warns
    // with S154. So red increases with x, and blue increases with z.
    std::string gltf = replaced(square_gltf(), R"("POSITION": 0)", R"("POSITION": 0, "COLOR_0": 0)");
    gltf = replaced(gltf, R"([0.8, 0.2, 0.1, 1],)", R"([0.5, 1, 0.25, 1],)");
    gltf = replaced(gltf, R"("doubleSided": true,)",
                    R"("doubleSided": true, "extensions": { "KHR_materials_unlit": {} },)");
    const RunResult run = render(gltf, {"--size", "64x36", "--resource", "hdr", "-o", "out.pfm"});
    ASSERT_EQ(run.exit_code, 0) << run.text();
    EXPECT_NE(run.err.find("S154"), std::string::npos) << run.text();
    const auto image = read_pfm(folder_ / "out.pfm");
    ASSERT_TRUE(image);
    uint32_t inside = 0;
    for (uint32_t j = 0; j < image->height_px; ++j) {
        for (uint32_t i = 0; i < image->width_px; ++i) {
            const Ground at = ground_at(i, j, image->width_px, image->height_px);
            if (std::abs(at.x) > 0.95 || std::abs(at.z) > 0.95) continue;
            ++inside;
            EXPECT_NEAR(image->at(i, j)[0], 0.5 * (at.x + 1) / 2, 1e-3) << i << " " << j;
            EXPECT_GE(image->at(i, j)[1], 0) << i << " " << j;
            EXPECT_LT(image->at(i, j)[1], 1e-6) << i << " " << j;
            EXPECT_NEAR(image->at(i, j)[2], 0.25 * (at.z + 1) / 2, 1e-3) << i << " " << j;
        }
    }
    EXPECT_GT(inside, 100u);
}

std::string glass_square() {
    const std::string clear = replaced(square_gltf(), R"([0.8, 0.2, 0.1, 1],)", R"([0.8, 0.2, 0.1, 0.5],)");
    return replaced(clear, R"("doubleSided": true,)", R"("name": "glass", "alphaMode": "BLEND",)");
}

TEST_P(ForeignScene, WhatIsDrawnIsNotMissed) {
    const RunResult run = render(glass_square(), {"--size", "32x18", "-o", "out.png"});
    ASSERT_EQ(run.exit_code, 0) << run.text();
    EXPECT_EQ(run.err.find("S155"), std::string::npos) << run.text();
}

TEST(ForeignSceneLeftOut, IsSaidOnce) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder folder;
    // The graph is the shipped deferred pipeline without its pass "glass", which draws transparent surfaces.
    folder.write("graph.json",
                 R"({ "version": 1, "include": ["deferred.json"], "passes": { "glass": null } })");
    folder.write("scene.gltf", glass_square());
    const RunResult run =
        run_weft({"render", "scene.gltf", "--graph", "graph.json", "--size", "32x18", "-o", "out.png"}, {},
                 folder.path());
    ASSERT_EQ(run.exit_code, 0) << run.text();
    const size_t said =
        run.err.find("warning[S155]: 1 transparent object is not drawn (BLEND materials: \"glass\")");
    ASSERT_NE(said, std::string::npos) << run.text();
    EXPECT_NE(run.err.find("--graph graphs/forward.json"), std::string::npos) << run.text();
    EXPECT_EQ(run.err.find("S155", said + std::string("warning[S155]").size()), std::string::npos)
        << run.text();
}

}  // namespace
}  // namespace weft::test

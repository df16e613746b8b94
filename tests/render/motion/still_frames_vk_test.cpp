// Tests that the picture of a still camera is calm after 32 frames, with temporal anti-aliasing and with
// reflections: the FLIP error of neighbouring frames is at most 0.005 in the mean and 0.05 in 99 % of the
// pixels.
#include <algorithm>
#include <numeric>

#include "tests/render/session_fixture.h"
#include "weft/image/flip.h"

namespace weft::test {
namespace {

constexpr Extent3D kCalmSize{640, 360, 1};
constexpr int kFramesBefore32 = 33;
constexpr size_t kPoolCamera = 2;  // Of the atrium.

class StillFrames : public SessionTest {
 protected:
    static image::Image picture_of(render::Session& session) {
        EXPECT_TRUE(draw_frame(session) && session.finish());
        const Result<vk::ReadbackData> output = session.read_output();
        EXPECT_TRUE(output);
        image::Image picture;
        picture.width_px = kCalmSize.width;
        picture.height_px = kCalmSize.height;
        for (size_t i = 0; output && i < output->bytes.size(); i += 4) {
            glm::vec3 color;
            for (int channel = 0; channel < 3; ++channel)
                color[channel] = float(std::to_integer<int>(output->bytes[i + size_t(channel)])) / 255;
            picture.texels.push_back(color);
        }
        return picture;
    }
    void expect_calm(const std::string& graph, size_t camera) {
        const Result<scene::Scene> scene = scene::make_builtin("atrium");
        ASSERT_TRUE(scene);
        const std::unique_ptr<render::Session> session =
            start(*scene, scene->cameras.at(camera), graph_path(graph), kCalmSize, {});
        ASSERT_TRUE(session);
        // A fixed exposure: otherwise the eye still adapts.
        frame_of(*session).exposure_ev = -12;
        frame_of(*session).parameters["autoExposure"] = 0;
        for (int i = 0; i < kFramesBefore32; ++i) ASSERT_TRUE(draw_frame(*session));
        const image::Image first = picture_of(*session), second = picture_of(*session);
        image::Plane map = image::flip_map(first, second);
        std::ranges::sort(map.values);
        const double mean =
            std::accumulate(map.values.begin(), map.values.end(), 0.0) / double(map.values.size());
        const float most = map.values[map.values.size() * 99 / 100];
        std::printf("FLIP of neighbouring frames: mean %.5f, 99th percentile %.4f\n", mean, most);
        EXPECT_LE(mean, 0.005);
        EXPECT_LE(most, 0.05);
    }
};

TEST_F(StillFrames, AreCalmWithAntiAliasing) {
    expect_calm("taa", 0);
}

// The camera looks at the pool, which mirrors the court in ripples.
TEST_F(StillFrames, AreCalmWithReflections) {
    expect_calm("reflections", kPoolCamera);
}

}  // namespace
}  // namespace weft::test

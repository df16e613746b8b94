// Tests that the picture of a still camera with temporal anti-aliasing is calm after 32 frames: the FLIP
// error of neighbouring frames is at most 0.005 in the mean and 0.05 in 99 % of the pixels.
#include <algorithm>
#include <numeric>

#include "tests/render/session_fixture.h"
#include "weft/image/flip.h"

namespace weft::test {
namespace {

constexpr Extent3D kCalmSize{640, 360, 1};
constexpr int kFramesBefore32 = 33;

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
};

TEST_F(StillFrames, AreCalmAfterThirtyTwoFrames) {
    const Result<scene::Scene> scene = scene::make_builtin("atrium");
    ASSERT_TRUE(scene);
    const std::unique_ptr<render::Session> session =
        start(*scene, scene->cameras.front(), graph_path("taa"), kCalmSize, {});
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

}  // namespace
}  // namespace weft::test

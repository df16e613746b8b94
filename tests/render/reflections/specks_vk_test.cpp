// Tests that small lamps leave no bright specks on a rough floor: after 32 frames, no pixel is above three
// times the converged light of its neighbourhood, and the mean of a frame is that of many frames. For lamps
// that are 200 times as bright as the rest, the limit is six times.
#include <algorithm>
#include <cmath>

#include "tests/render/reflections/reflection_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kSpeckSize{160, 90, 1};
constexpr int kFirstFrame = 32, kAllFrames = 160;

class ReflectionSpecks : public ReflectionTest {
 protected:
    // A rough floor with a dim wall and two lamps.
    static scene::Scene lamps_on_floor(float roughness, float radiance) {
        scene::Scene scene;
        scene.sky_zenith = scene.sky_horizon = glm::vec3(0.05f);
        add_box(scene, {-4, -0.1f, -4}, {4, 0, 4}, metal(roughness));
        add_box(scene, {-4, 0, -2.1f}, {4, 1.2f, -2}, emitter(glm::vec3(0.1f)));
        add_box(scene, {-0.1f, 0.4f, -1}, {0, 0.5f, -0.9f}, emitter(glm::vec3(radiance)));
        add_box(scene, {0.8f, 0.2f, -1.4f}, {0.84f, 0.9f, -1.36f},
                emitter(radiance * glm::vec3(0.4f, 0.2f, 0.05f)));
        return scene;
    }
    // Returns the light of each frame from kFirstFrame on, summed over the channels.
    std::vector<std::vector<float>> film(float roughness, float radiance) {
        const std::unique_ptr<render::Session> session =
            start(lamps_on_floor(roughness, radiance),
                  scene::camera_looking_at({0.2f, 0.9f, 2.2f}, {0.2f, 0.2f, -0.6f}, 0.7f), kReflectionGraph,
                  kSpeckSize, {"hdr"});
        std::vector<std::vector<float>> frames;
        if (session) frame_of(*session).parameters["autoExposure"] = 0;
        for (int i = 0; session && i < kAllFrames; ++i) {
            EXPECT_TRUE(draw_frame(*session) && session->finish());
            for (const vk::ReadbackData& data : session->take_readbacks()) {
                if (i < kFirstFrame) continue;
                frames.emplace_back();
                for (const glm::vec4& light : render::decode_texels(data.format, data.bytes))
                    frames.back().push_back((light.r + light.g + light.b) / session->pre_exposure());
            }
        }
        return frames;
    }
    static std::vector<float> mean_of(const std::vector<std::vector<float>>& frames) {
        std::vector<float> mean(frames.front().size(), 0);
        for (const std::vector<float>& frame : frames)
            for (size_t at = 0; at < mean.size(); ++at) mean[at] += frame[at] / float(frames.size());
        return mean;
    }
    // Returns the largest light of the 5 × 5 pixels around a pixel.
    static float most_around(const std::vector<float>& light, int x, int y) {
        float most = 0;
        for (int i = std::max(y - 2, 0); i <= std::min(y + 2, int(kSpeckSize.height) - 1); ++i)
            for (int j = std::max(x - 2, 0); j <= std::min(x + 2, int(kSpeckSize.width) - 1); ++j)
                most = std::max(most, light[size_t(i) * kSpeckSize.width + size_t(j)]);
        return most;
    }
    void expect_no_specks(float roughness, float radiance, double limit) {
        const std::vector<std::vector<float>> frames = film(roughness, radiance);
        ASSERT_EQ(frames.size(), size_t(kAllFrames - kFirstFrame));
        const std::vector<float> converged = mean_of(frames);
        double all = 0, worst_speck = 0, worst_mean = 0;
        for (const float light : converged) all += double(light);
        for (const std::vector<float>& frame : frames) {
            double sum = 0;
            for (int y = 0; y < int(kSpeckSize.height); ++y) {
                for (int x = 0; x < int(kSpeckSize.width); ++x) {
                    const float light = frame[size_t(y) * kSpeckSize.width + size_t(x)];
                    sum += double(light);
                    worst_speck = std::max(worst_speck, double(light / most_around(converged, x, y)));
                }
            }
            worst_mean = std::max(worst_mean, std::abs(sum / all - 1));
        }
        std::printf(
            "roughness %.2f, lamp %2.0f: brightest %.2f times the neighbourhood, mean off by at most %.4f\n",
            double(roughness), double(radiance), worst_speck, worst_mean);
        EXPECT_LE(worst_speck, limit);
        EXPECT_LE(worst_mean, radiance < 10 ? 0.02 : 0.05);
    }
};

TEST_F(ReflectionSpecks, AreAtMostThreeTimesTheNeighbourhood) {
    for (const float roughness : {0.1f, 0.2f, 0.35f, 0.5f}) expect_no_specks(roughness, 1, 3);
}

TEST_F(ReflectionSpecks, OfVeryBrightLampsAreLimited) {
    for (const float roughness : {0.1f, 0.35f}) expect_no_specks(roughness, 20, 6);
}

}  // namespace
}  // namespace weft::test

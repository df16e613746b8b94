// Tests that reflections leave no trail: eight frames after an object has gone, or after the camera has
// stopped, the floor mirrors what it mirrors without this past.
#include <algorithm>

#include "tests/render/reflections/reflection_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kTrailSize{240, 136, 1};
constexpr uint32_t kNewColumns = 20;
constexpr int kFramesBefore = 16, kFramesAfter = 8;
constexpr double kFrame_s = 1.0 / 60;

class ReflectionTrail : public ReflectionTest {
 protected:
    // A striped wall behind a metal floor, and a red box between them that is far away from kFramesBefore on.
    static scene::Scene stage(float roughness, bool with_box) {
        scene::Scene scene;
        scene.sky_zenith = scene.sky_horizon = glm::vec3(0.1f);
        add_box(scene, {-4, -0.1f, -4}, {4, 0, 4}, metal(roughness));
        add_box(scene, {-4, 0, -2.1f}, {4, 2, -2}, emitter({0.2f, 0.2f, 0.2f}));
        for (int i = -9; i <= 9; ++i) {
            const float x = 0.4f * float(i);
            add_box(scene, {x, 0, -2}, {x + 0.2f, 1.5f, -1.95f}, emitter({0.5f, 0.5f, 0.6f}));
        }
        scene.motion.nodes = {{}};
        scene::Animation animation;
        animation.length_s = 100;
        animation.samplers = {{scene::Interpolation::step,
                               false,
                               {0, float((kFramesBefore - 0.5) * kFrame_s)},
                               {{0, 0, 0, 0}, {0, 0, 100, 0}}}};
        animation.channels = {{0, scene::MotionPath::translation, 0}};
        scene.motion.animations = {animation};
        if (with_box) {
            add_box(scene, {-0.5f, 0, -1}, {0.5f, 0.8f, -0.4f}, emitter({0.9f, 0.1f, 0.1f}));
            scene.instances.back().node = 0;
        }
        return scene;
    }
    // Returns the picture of each frame, scene-linear and with an exposure of 1.
    std::vector<std::vector<glm::vec4>> film(const scene::Scene& scene, bool camera_moves) {
        const std::unique_ptr<render::Session> session =
            start(scene, camera_of(0), kReflectionGraph, kTrailSize, {"hdr"});
        std::vector<std::vector<glm::vec4>> frames;
        for (int i = 0; session && i < kFramesBefore + kFramesAfter; ++i) {
            frame_of(*session).parameters["autoExposure"] = 0;
            frame_of(*session).camera = camera_of(camera_moves ? std::min(i, kFramesBefore) : kFramesBefore);
            EXPECT_TRUE(draw_frame(*session, i * kFrame_s) && session->finish());
            for (const vk::ReadbackData& data : session->take_readbacks()) {
                frames.push_back(render::decode_texels(data.format, data.bytes));
                for (glm::vec4& light : frames.back()) light /= session->pre_exposure();
            }
        }
        return frames;
    }
    // The camera moves by 5 cm in each frame, to the right and towards the wall.
    static scene::Camera camera_of(int frame) {
        const float moved_m = 0.05f * float(frame - kFramesBefore);
        return scene::camera_looking_at({moved_m, 1.0f, 2.6f - 0.5f * moved_m}, {moved_m, 0.3f, -1}, 0.8f);
    }
    // Returns the largest mean difference of 4 × 4 pixels. Near the edges of the picture, the moving camera
    // has seen the floor for a few frames only, so the mean is noisy there.
    static double difference(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
        double most = 0;
        for (uint32_t y = 0; y + 4 <= kTrailSize.height; y += 4) {
            for (uint32_t x = kNewColumns; x + 4 <= kTrailSize.width - kNewColumns; x += 4) {
                glm::vec3 sum(0);
                for (uint32_t i = 0; i < 16; ++i) {
                    const size_t at = (y + i / 4) * kTrailSize.width + x + i % 4;
                    sum += glm::vec3(a[at] - b[at]);
                }
                most = std::max(
                    {most, double(std::abs(sum.r)), double(std::abs(sum.g)), double(std::abs(sum.b))});
            }
        }
        return most / 16;
    }
};

TEST_F(ReflectionTrail, OfAnObjectIsGoneAfterEightFrames) {
    for (const float roughness : {0.0f, 0.25f}) {
        const auto with = film(stage(roughness, true), false), without = film(stage(roughness, false), false);
        ASSERT_EQ(with.size(), without.size());
        const double before = difference(with[kFramesBefore - 1], without[kFramesBefore - 1]);
        const double after = difference(with.back(), without.back());
        std::printf("roughness %.2f: difference %.3f with the box, %.4f eight frames later\n",
                    double(roughness), before, after);
        EXPECT_GT(before, 0.3);
        EXPECT_LE(after, 0.05 * before);
    }
}

TEST_F(ReflectionTrail, OfTheCameraIsGoneAfterEightFrames) {
    for (const float roughness : {0.0f, 0.25f}) {
        const auto moved = film(stage(roughness, true), true), still = film(stage(roughness, true), false);
        ASSERT_EQ(moved.size(), still.size());
        const double after = difference(moved.back(), still.back());
        std::printf("roughness %.2f: difference %.4f\n", double(roughness), after);
        EXPECT_LE(after, 0.08);
    }
}

}  // namespace
}  // namespace weft::test

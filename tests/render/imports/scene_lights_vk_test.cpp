// Tests the import "sceneLights": passes with "rest" that read it run only if a light has changed, and see
// the lights of the frame.
#include <cstring>

#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr const char* kLightsGraph = WEFT_SOURCE_DIR "/tests/render/imports/lights.json";

class SceneLights : public SessionTest {
 protected:
    // Renders a frame, and returns true if the pass "read" ran.
    bool frame(render::Session& session) {
        EXPECT_TRUE(draw_frame(session));
        EXPECT_TRUE(session.finish());
        bool ran = false;
        for (const vk::FrameTiming& timing : session.take_timings())
            for (const vk::PassTiming& pass : timing.passes) ran |= pass.pass == "read" && !pass.rested;
        for (const vk::ReadbackData& data : session.take_readbacks()) {
            EXPECT_EQ(data.bytes.size(), sizeof seen_);
            if (data.bytes.size() == sizeof seen_) std::memcpy(seen_.data(), data.bytes.data(), sizeof seen_);
        }
        return ran;
    }

    std::array<shared::Light, 2> seen_{};
};

TEST_F(SceneLights, WakeAPassOnlyIfALightHasChanged) {
    const Result<scene::Scene> scene = scene::make_builtin("spheres");
    ASSERT_TRUE(scene);
    const auto session = start(*scene, scene::framing_camera(*scene, 1), kLightsGraph, {16, 16, 1}, {"seen"});
    ASSERT_TRUE(session);
    EXPECT_TRUE(frame(*session));
    EXPECT_EQ(seen_[0].type, shared::kLightPoint);
    const glm::vec3 before = seen_[0].intensity;
    EXPECT_EQ(before, session->parts().scene.lights()[0].intensity);
    EXPECT_FALSE(frame(*session));
    frame_of(*session).camera.transform[3].x += 1;
    frame_of(*session).exposure_ev = 2;
    EXPECT_FALSE(frame(*session)) << "the camera and the exposure are no lights";

    scene::Light lamp;
    lamp.type = scene::LightType::spot;
    lamp.intensity = 5;
    frame_of(*session).lights = {lamp};
    EXPECT_TRUE(frame(*session));
    EXPECT_EQ(seen_[0].type, shared::kLightSpot);
    EXPECT_EQ(seen_[0].intensity, glm::vec3(5));
    // Each frame slot has a buffer of its own, and a change reaches all of them.
    for (uint32_t i = 0; i < 2 * vk::kFramesInFlight; ++i) EXPECT_FALSE(frame(*session)) << i;
    for (uint32_t i = 0; i < 2 * vk::kFramesInFlight; ++i) {
        frame_of(*session).lights->front().intensity = 6 + static_cast<float>(i);
        EXPECT_TRUE(frame(*session)) << i;
        EXPECT_EQ(seen_[0].intensity, glm::vec3(6 + static_cast<float>(i)));
    }
    frame_of(*session).lights.reset();
    EXPECT_TRUE(frame(*session));
    EXPECT_EQ(seen_[0].intensity, before);
}

}  // namespace
}  // namespace weft::test

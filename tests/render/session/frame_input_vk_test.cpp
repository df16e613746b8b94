// Tests values that change from frame to frame: the camera and the exposure.
#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kSize{64, 36, 1};

class FrameInputs : public SessionTest {
 protected:
    void SetUp() override {
        SessionTest::SetUp();
        Result<scene::Scene> scene = scene::make_builtin("spheres");
        ASSERT_TRUE(scene);
        scene_ = std::move(*scene);
        before_ = {.camera = scene_.cameras.at(0), .exposure_ev = scene_.exposure_ev};
        after_ = before_;
        after_.camera.transform[3] += glm::vec4(0.5f, 0.25f, 0, 0);
        after_.exposure_ev += 1;
    }
    std::unique_ptr<render::Session> begin(const render::FrameInput& first) {
        std::unique_ptr<render::Session> session =
            start(scene_, first.camera, kDeferredGraph, kSize, {}, first.exposure_ev);
        if (!session) return nullptr;
        EXPECT_TRUE(session->render_frame(first));
        return session;
    }
    static std::vector<std::byte> picture(render::Session& session) {
        EXPECT_TRUE(session.finish());
        Result<vk::ReadbackData> output = session.read_output();
        EXPECT_TRUE(output);
        return output ? std::move(output->bytes) : std::vector<std::byte>();
    }

    scene::Scene scene_;
    render::FrameInput before_, after_;
};

TEST_F(FrameInputs, AChangedOneGivesThePictureOfASessionThatBeginsWithIt) {
    const std::unique_ptr<render::Session> session = begin(before_), fresh = begin(after_);
    ASSERT_TRUE(session && fresh);
    const std::vector<std::byte> first = picture(*session);
    ASSERT_TRUE(session->render_frame(after_));
    const std::vector<std::byte> second = picture(*session);
    EXPECT_TRUE(second == picture(*fresh));
    EXPECT_FALSE(second == first);
}

TEST_F(FrameInputs, AfterACutOfTheCameraThereIsNoHistory) {
    const std::unique_ptr<render::Session> session = start(scene_, before_.camera, graph_path("taa"), kSize,
                                                           {"resolved", "velocity"}, before_.exposure_ev);
    ASSERT_TRUE(session);
    // Returns the largest number of blended frames, which `resolved` contains, and the longest velocity.
    const auto most = [&](const render::FrameInput& input) {
        EXPECT_TRUE(session->render_frame(input) && session->finish());
        glm::vec2 found(0);
        for (const vk::ReadbackData& data : session->take_readbacks())
            for (const glm::vec4& texel : render::decode_texels(data.format, data.bytes))
                if (data.pass == "observe:resolved")
                    found.x = std::max(found.x, texel.a);
                else
                    found.y = std::max(found.y, glm::length(glm::vec2(texel)));
        return found;
    };
    EXPECT_EQ(most(before_), glm::vec2(1, 0));
    EXPECT_EQ(most(before_).x, 2);
    const glm::vec2 moved = most(after_);
    EXPECT_EQ(moved.x, 3);
    EXPECT_GT(moved.y, 0.01f);
    before_.camera_cut = true;
    EXPECT_EQ(most(before_), glm::vec2(1, 0));
    before_.camera_cut = false;
    EXPECT_EQ(most(before_).x, 2) << "the history goes on with the frame after the cut";
}

TEST_F(FrameInputs, TheFrameBeforeIsKnown) {
    const std::unique_ptr<render::Session> session = begin(before_);
    ASSERT_TRUE(session);
    const render::FrameLoop& frames = session->parts().frames;
    const glm::mat4 first = frames.view().steady_view_projection;
    EXPECT_EQ(frames.view().prev_view_projection, first) << "the first frame has none before it";
    ASSERT_TRUE(session->render_frame(after_));
    EXPECT_NE(frames.view().steady_view_projection, first);
    EXPECT_EQ(frames.view().prev_view_projection, first);
    EXPECT_EQ(session->pre_exposure(), std::exp2(after_.exposure_ev));
    ASSERT_TRUE(session->finish());
}

TEST_F(FrameInputs, ShadersSeeTheExposureOfTheFrameAndOfTheOneBefore) {
    const std::unique_ptr<render::Session> session =
        start(WEFT_SOURCE_DIR "/tests/render/frame_input/exposures.json", kSize, {"seen"});
    ASSERT_TRUE(session);
    const std::vector<float> exposures_ev{1, 1, 3, -2};
    for (const float exposure_ev : exposures_ev)
        ASSERT_TRUE(session->render_frame({.camera = before_.camera, .exposure_ev = exposure_ev}));
    ASSERT_TRUE(session->finish());
    const std::vector<vk::ReadbackData> seen = session->take_readbacks();
    ASSERT_EQ(seen.size(), exposures_ev.size());
    for (size_t i = 0; i < seen.size(); ++i) {
        const float now = std::exp2(exposures_ev[i]), before = std::exp2(exposures_ev[i > 0 ? i - 1 : 0]);
        EXPECT_EQ(render::decode_texels(seen[i].format, seen[i].bytes).at(0),
                  glm::vec4(now, before, now, before))
            << "frame " << i;
    }
}

}  // namespace
}  // namespace weft::test

// Tests that temporal anti-aliasing follows a lamp that is switched off: after four frames, at most 2 % of
// the light of the lamp is left in the mean of the frames, also on textures and at edges. The mean of a still
// picture would otherwise keep most of the light for many frames.
#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kStepSize{192, 108, 1};
constexpr int kFramesBefore = 40, kFramesAfter = 4;
constexpr double kMostLeft = 0.02;

class LightStep : public SessionTest, public testing::WithParamInterface<float> {
 protected:
    // A session that shows the court by day, with a lamp of this intensity over the pool.
    std::unique_ptr<render::Session> begin(float candela) {
        Result<scene::Scene> scene = scene::make_builtin("atrium");
        if (!scene) return nullptr;
        scene->lights.push_back(lamp(candela));
        lights_ = scene->lights;
        return start(*scene, scene->cameras.front(), graph_path("taa"), kStepSize, {"resolved"});
    }
    static scene::Light lamp(float candela) {
        scene::Light light;
        light.position = {0, 4, 0};
        light.intensity = candela;
        return light;
    }
    // Draws frames and returns the sum of the channels in the last one, for each pixel, in cd/m².
    static std::vector<double> draw(render::Session& session, int frames) {
        for (int i = 0; i < frames; ++i) EXPECT_TRUE(draw_frame(session));
        EXPECT_TRUE(session.finish());
        std::vector<double> light;
        for (const vk::ReadbackData& data : session.take_readbacks()) {
            light.clear();
            for (const glm::vec4& texel : render::decode_texels(data.format, data.bytes))
                light.push_back((double{texel.r} + texel.g + texel.b) / session.pre_exposure());
        }
        return light;
    }

    // The same, but the mean of the frames begins again with the first of these frames.
    static std::vector<double> draw_from_cut(render::Session& session, int frames) {
        frame_of(session).camera_cut = true;
        EXPECT_TRUE(draw_frame(session));
        frame_of(session).camera_cut = false;
        return draw(session, frames - 1);
    }

    std::vector<scene::Light> lights_;
};

TEST_P(LightStep, LeavesNothingOfALampThatIsSwitchedOff) {
    // The strong lamp is the harder case.
    if (GetParam() < 1e6f && std::getenv("WEFT_EXTENDED") == nullptr)
        GTEST_SKIP() << "only with WEFT_EXTENDED";
    const std::unique_ptr<render::Session> lit = begin(GetParam()), dark = begin(0);
    ASSERT_TRUE(lit && dark);
    const std::vector<double> before = draw(*lit, kFramesBefore), without = draw(*dark, kFramesBefore);
    lights_.back() = lamp(0);
    frame_of(*lit).lights = lights_;
    const std::vector<double> after = draw(*lit, kFramesAfter), end = draw_from_cut(*dark, kFramesAfter);
    // The share of the lamp's light that is left, in the least-squares sense. Where the mean of the frames
    // begins again, it also differs from the reference because it has fewer samples. This noise does not
    // depend on the light of the lamp.
    double lamp_light = 0, rest = 0, product = 0, square = 0, sum = 0;
    ASSERT_EQ(after.size(), end.size());
    for (size_t i = 0; i < after.size(); ++i) {
        const double added = before[i] - without[i];
        lamp_light += added;
        rest += end[i];
        product += added * (after[i] - end[i]);
        square += added * added;
        sum += after[i] - end[i];
    }
    const double left = product / square;
    std::printf("the lamp added %.3f of the light; after %d frames, %.4f of it is left (sum %.4f)\n",
                lamp_light / rest, kFramesAfter, left, sum / lamp_light);
    EXPECT_GT(lamp_light, 0.05 * rest);
    EXPECT_LE(std::abs(left), kMostLeft);
}

INSTANTIATE_TEST_SUITE_P(All, LightStep, testing::Values(200'000.0f, 2'000'000.0f));

}  // namespace
}  // namespace weft::test

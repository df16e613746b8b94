// Tests the reflections of smooth metal in a closed dark room beside a lit court.
#include "tests/render/probes/picture_fixture.h"

namespace weft::test {
namespace {

constexpr std::array<float, 3> kRoughness{0, 0.05f, 0.1f};
constexpr float kRadius_m = 0.25f;

// Each room has one ball for each roughness, at this distance from the wall between the rooms.
std::array<Ball, kRoughness.size()> balls_at(float x) {
    std::array<Ball, kRoughness.size()> balls;
    for (size_t i = 0; i < balls.size(); ++i) balls[i] = {{x, 1, float(i) - 1}, kRadius_m};
    return balls;
}

scene::Scene scene_with_balls(float from_wall_m) {
    scene::Scene scene = dark_room_beside_court().scene;
    scene.lights = {sun_from({-0.4f, -1, -0.3f}, 50'000)};
    for (size_t i = 0; i < kRoughness.size(); ++i) {
        const uint32_t chrome = add_metal(scene, glm::vec3(0.9f), kRoughness[i]);
        for (const float x : {-from_wall_m, from_wall_m}) {
            const Ball ball = balls_at(x)[i];
            scene::MeshBuilder builder;
            builder.add_sphere(ball.middle, ball.radius_m, 48, 24);
            place(scene, builder.finish("ball"), chrome);
        }
    }
    return scene;
}

// The light of the balls of a room, as the camera at the other side of the room sees it.
using Means = std::array<double, kRoughness.size()>;

class ChromeBall : public ProbePicture {
 protected:
    Means look(render::Session& session, float side, float from_wall_m) {
        const float eye = from_wall_m > 1 ? 0.3f : 2.6f;
        const scene::Camera camera = camera_at({side * eye, 1.2f, 0}, {side * from_wall_m, 1, 0}, 1.2f);
        const std::vector<glm::vec3> seen = picture(session, camera);
        Means means{};
        if (seen.empty()) return means;
        for (size_t i = 0; i < means.size(); ++i)
            means[i] = mean_of(seen, pixels_of(balls_at(side * from_wall_m)[i], camera, kSize));
        return means;
    }

    void expect_dark(const scene::Scene& scene, const scene::Probes& probes, float from_wall_m,
                     const char* name) {
        const glm::vec3 sky(4000);
        const std::unique_ptr<render::Session> session = begin(scene, probes, {sky, sky, sky});
        ASSERT_TRUE(session);
        const Means dark = look(*session, -1, from_wall_m), lit = look(*session, 1, from_wall_m);
        for (size_t i = 0; i < kRoughness.size(); ++i) {
            std::printf("%s, roughness %.2f: %.2f in the dark room, %.0f in the court: %.3f %%\n", name,
                        double{kRoughness[i]}, dark[i], lit[i], 100 * dark[i] / lit[i]);
            EXPECT_GT(lit[i], 1000) << name;
            EXPECT_LT(dark[i], 0.02 * lit[i]) << name << ", roughness " << kRoughness[i];
        }
    }
};

// The reflection probes are those that Weft places, or one in the court only, or none. Without a probe that
// sees the ball, the illuminance darkens the sky.
TEST_F(ChromeBall, InADarkRoomMirrorsLessThanTwoPercentOfTheLightInTheCourt) {
    constexpr float kFromWall_m = 0.4f;
    const scene::Scene scene = scene_with_balls(kFromWall_m);
    scene::Probes probes = placed(scene, 60);
    ASSERT_GE(probes.reflections.size(), 2u);
    expect_dark(scene, probes, kFromWall_m, "automatic");
    probes.reflections = {{"court", {1.2f, 1.3f, 0.2f}, std::nullopt}};
    expect_dark(scene, probes, kFromWall_m, "probe in the court");
    probes.reflections.clear();
    expect_dark(scene, probes, kFromWall_m, "no probe");
}

}  // namespace
}  // namespace weft::test

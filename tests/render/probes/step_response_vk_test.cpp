// Tests what happens after a lamp is switched off: its direct light is gone in the next frame. The light that
// surfaces reflect and the mirrored light fall with each turn of the probes, and never below that of a scene
// without the lamp.
#include <cstring>

#include "shared/probe_sh.glsl"
#include "tests/render/probes/picture_fixture.h"

namespace weft::test {
namespace {

constexpr float kWallAlbedo = 0.6f, kOpenSky = 100, kCandela = 3000;
// Probes rest after six rounds; what would change later is at most this share.
constexpr double kStill = 0.005;
const Ball kBall{{0.3f, 1, -0.3f}, 0.45f};
const glm::vec3 kLamp{-0.8f, 1.7f, 0.5f};

// A room of 3 m × 2.4 m × 3 m without a wall towards +z, with a ball of metal.
scene::Scene open_room() {
    scene::test::BoxScene boxes;
    boxes.add({-1.6f, -0.1f, -1.6f}, {1.6f, 0, 1.5f});
    boxes.add({-1.6f, 2.4f, -1.6f}, {1.6f, 2.5f, 1.5f});
    boxes.add({-1.6f, 0, -1.6f}, {-1.5f, 2.4f, 1.5f});
    boxes.add({1.5f, 0, -1.6f}, {1.6f, 2.4f, 1.5f});
    boxes.add({-1.5f, 0, -1.6f}, {1.5f, 2.4f, -1.5f});
    scene::Scene& scene = boxes.scene;
    scene.materials[0].base_color = glm::vec4(glm::vec3(kWallAlbedo), 1);
    scene.materials[0].specular = 0;
    scene::MeshBuilder builder;
    builder.add_sphere(kBall.middle, kBall.radius_m, 48, 24);
    const uint32_t metal = add_metal(scene, glm::vec3(0.9f), 0.05f);
    place(scene, builder.finish("ball"), metal);
    return scene;
}

scene::Light lamp_of(float candela) {
    scene::Light lamp;
    lamp.position = kLamp;
    lamp.intensity = candela;
    return lamp;
}

class StepResponse : public ProbePicture {
 protected:
    struct State {
        std::vector<glm::vec3> picture;
        std::vector<double> volume;  // The mean radiance that each probe sees.
    };

    std::unique_ptr<render::Session> lit_by(float candela, scene::Probes probes) {
        scene::Scene scene = open_room();
        scene.lights = {lamp_of(candela)};
        const glm::vec3 sky(kOpenSky);
        return begin(scene, std::move(probes), {sky, sky, sky}, 24, {"hdr", "probeSh"});
    }

    State step(render::Session& session) {
        frame_of(session).camera = camera_at({0.6f, 1.4f, 3.2f}, {0, 1.1f, 0}, 0.9f);
        Status done = draw_frame(session);
        if (done) done = session.finish();
        EXPECT_TRUE(done) << to_text(done.errors());
        State state;
        for (const vk::ReadbackData& data : session.take_readbacks()) {
            if (data.pass == "observe:hdr") {
                for (const glm::vec4& texel : render::decode_texels(data.format, data.bytes))
                    state.picture.push_back(glm::vec3(texel) / session.pre_exposure());
                continue;
            }
            constexpr size_t kStride = shared::kProbeShStride * sizeof(glm::vec4);
            for (size_t at = 0; at + kStride <= data.bytes.size(); at += kStride) {
                glm::vec4 first;
                std::memcpy(&first, data.bytes.data() + at, sizeof first);
                state.volume.push_back(double{first.g});
            }
        }
        EXPECT_EQ(state.picture.size(), size_t{kSize.x} * kSize.y);
        EXPECT_EQ(state.volume.size(), session.probe_count());
        return state;
    }
};

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value / static_cast<double>(values.size());
    return sum;
}

// Returns the direct light of the lamp that each pixel of the floor reflects; 0 elsewhere. Lamps throw no
// shadows.
std::vector<double> direct_light(const scene::Camera& camera, glm::uvec2 size, double candela) {
    std::vector<double> light(size_t{size.x} * size.y, 0);
    const std::vector<size_t> ball = pixels_of({kBall.middle, kBall.radius_m * 1.2f}, camera, size);
    const glm::vec3 eye(camera.transform[3]);
    for (size_t i = 0; i < light.size(); ++i) {
        const glm::vec3 way = way_of(camera, size, i), at = eye - way * (eye.y / way.y);
        const bool is_floor = way.y < 0 && std::abs(at.x) < 1.45f && std::abs(at.z) < 1.45f;
        if (!is_floor || std::ranges::binary_search(ball, i)) continue;
        const glm::dvec3 to_lamp = glm::dvec3(kLamp) - glm::dvec3(at);
        const double away_m = glm::length(to_lamp);
        light[i] = double{kWallAlbedo} / std::numbers::pi * candela * to_lamp.y / (away_m * away_m * away_m);
    }
    return light;
}

// The first picture without the lamp has lost all of its direct light, and little else.
void expect_no_direct_light(const std::vector<glm::vec3>& before, const std::vector<glm::vec3>& after,
                            const std::vector<double>& direct, double reflected) {
    size_t count = 0;
    for (size_t i = 0; i < direct.size(); ++i) {
        if (direct[i] == 0) continue;
        ++count;
        const double lost = double{before[i].g} - double{after[i].g};
        EXPECT_NEAR(lost, direct[i], 0.002 * double{before[i].g} + 0.05 * reflected) << "pixel " << i;
    }
    EXPECT_GT(count, 500u);
}

// Light that is reflected k times is gone after k cycles: in a cycle, all probes have a turn. The factor of a
// reflection is at most the albedo.
TEST_F(StepResponse, AfterALampIsSwitchedOffTheLightFallsToThatWithoutTheLamp) {
    constexpr uint32_t kCycles = 4;
    const scene::Probes probes = placed(open_room(), 60);
    const std::unique_ptr<render::Session> session = lit_by(kCandela, probes), dark = lit_by(0, probes);
    ASSERT_TRUE(session && dark);
    const State before = step(*session), end = step(*dark);
    const scene::Camera camera = frame_of(*session).camera;
    const std::vector<size_t> ball = pixels_of(kBall, camera, kSize);
    const double volume_step = mean(before.volume) - mean(end.volume);
    const double ball_end = mean_of(end.picture, ball), ball_step = mean_of(before.picture, ball) - ball_end;
    EXPECT_GT(volume_step, mean(end.volume));
    EXPECT_GT(ball_step, ball_end);

    frame_of(*session).lights = std::vector{lamp_of(0)};
    const uint32_t count = session->probe_count();
    EXPECT_GT(count, 40u);
    const uint32_t cycle = 2 * ((count + 3) / 4);
    State last = before;
    double most = 1, most_of_ball = 1;  // Limits of the light that is left, as shares of the step.
    for (uint32_t frame = 1; frame <= kCycles * cycle; ++frame) {
        const State now = step(*session);
        if (frame == 1)
            expect_no_direct_light(before.picture, now.picture, direct_light(camera, kSize, double{kCandela}),
                                   volume_step);
        for (size_t i = 0; i < count; ++i) {
            EXPECT_LT(now.volume[i], last.volume[i] * (1 + kStill)) << "probe " << i << ", frame " << frame;
            EXPECT_GT(now.volume[i], end.volume[i] * (1 - kStill)) << "probe " << i << ", frame " << frame;
        }
        const double seen = mean_of(now.picture, ball);
        EXPECT_LT(seen, mean_of(last.picture, ball) * (1 + kStill)) << "frame " << frame;
        EXPECT_GT(seen, ball_end * (1 - kStill)) << "frame " << frame;
        if (frame % cycle == 0) {
            most_of_ball = most;  // The ball mirrors the light of the cycle before.
            most *= double{kWallAlbedo};
            const double left = (mean(now.volume) - mean(end.volume)) / volume_step;
            const double mirrored = (seen - ball_end) / ball_step;
            std::printf("%u probes, frame %u: %.4f of the light is left, of reflections %.4f\n", count, frame,
                        left, mirrored);
            EXPECT_LT(left, most) << "frame " << frame;
            EXPECT_LT(mirrored, most_of_ball) << "frame " << frame;
        }
        last = now;
    }
    EXPECT_NEAR(mean(last.volume), mean(end.volume), kStill * volume_step);
    EXPECT_NEAR(mean_of(last.picture, ball), ball_end, kStill * ball_step);
}

}  // namespace
}  // namespace weft::test

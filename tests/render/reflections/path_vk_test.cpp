// Tests the reflections along a path of the camera, over a mirror, a rough floor and water: in each frame,
// the light is compared with that of a still camera at the same place after many frames, whose history has no
// other views.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tests/render/reflections/reflection_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kPathSize{240, 136, 1};
constexpr int kPathFrames = 24, kStillFrames = 33;
// Rows whose pixels show the floor in all frames, and columns of the three parts of the floor.
constexpr float kMirrorEnd = -0.7f, kWaterBegin = 0.7f;

scene::Material water() {
    scene::Material material;
    material.metallic = 0;
    material.roughness = 0.03f;
    material.ior = 1.33f;
    material.alpha_mode = scene::AlphaMode::blend;
    material.transmission = 1;
    material.thickness_m = 1;
    material.absorption_per_m = glm::vec3(2, 1, 1);
    return material;
}

// A striped wall and two boxes behind a floor with three parts.
scene::Scene stage() {
    scene::Scene scene;
    scene.sky_zenith = scene.sky_horizon = glm::vec3(0.1f);
    add_box(scene, {-4, -0.1f, -2}, {kMirrorEnd, 0, 4}, metal(0));
    add_box(scene, {kMirrorEnd, -0.1f, -2}, {kWaterBegin, 0, 4}, metal(0.25f));
    add_box(scene, {kWaterBegin, -0.4f, -2}, {4, -0.3f, 4}, emitter({0.05f, 0.1f, 0.1f}));
    add_box(scene, {kWaterBegin, -0.01f, -2}, {4, 0, 4}, water());
    add_box(scene, {-4, 0, -2.1f}, {4, 1.5f, -2}, emitter(glm::vec3(0.2f)));
    for (int i = -9; i <= 9; ++i)
        add_box(scene, {0.4f * float(i), 0, -2}, {0.4f * float(i) + 0.2f, 1.2f, -1.95f},
                emitter({0.5f, 0.5f, 0.6f}));
    add_box(scene, {-1.6f, 0, -1}, {-1.1f, 0.7f, -0.5f}, emitter({0.9f, 0.2f, 0.1f}));
    add_box(scene, {0.9f, 0, -1}, {1.3f, 0.6f, -0.6f}, emitter({0.1f, 0.7f, 0.9f}));
    return scene;
}

// The camera moves to the right and forwards, and turns.
scene::Camera camera_at(int frame) {
    const float t = float(frame) / kPathFrames;
    return scene::camera_looking_at({-0.9f + 1.8f * t, 1.0f - 0.2f * t, 3.0f - 0.5f * t},
                                    {0.5f - t, 0.2f, -1}, 0.8f);
}

// Mean differences, as shares of the mean light.
struct PartErrors {
    double mirror = 0, rough = 0, water = 0;
};

class ReflectionPath : public ReflectionTest {
 protected:
    struct Frame {
        std::vector<glm::vec4> light, depth;
        shared::ViewConstants view{};
    };
    std::unique_ptr<render::Session> begin(const scene::Scene& scene) {
        std::unique_ptr<render::Session> session =
            start(scene, camera_at(0), kReflectionGraph, kPathSize, {"hdr", "depth"});
        if (session) frame_of(*session).parameters["autoExposure"] = 0;
        return session;
    }
    static Frame draw_from(render::Session& session, const scene::Camera& camera, int frames = 1) {
        Frame frame;
        frame_of(session).camera = camera;
        for (int i = 0; i < frames; ++i) EXPECT_TRUE(draw_frame(session));
        EXPECT_TRUE(session.finish());
        for (const vk::ReadbackData& data : session.take_readbacks()) {
            std::vector<glm::vec4> texels = render::decode_texels(data.format, data.bytes);
            for (glm::vec4& light : texels)
                if (data.pass == "observe:hdr") light /= session.pre_exposure();
            (data.pass == "observe:hdr" ? frame.light : frame.depth) = std::move(texels);
        }
        frame.view = session.parts().frames.view();
        return frame;
    }
    // Compares the pixels that show the floor.
    static PartErrors errors_of(const Frame& moving, const Frame& still) {
        std::array<double, 3> off{}, sum{};
        for (int y = 0; y < int(kPathSize.height); ++y) {
            for (int x = 0; x < int(kPathSize.width); ++x) {
                const size_t at = size_t(y) * kPathSize.width + size_t(x);
                if (still.depth[at].r <= 0) continue;
                const glm::vec3 place = place_at(still.view, x, y, still.depth[at].r);
                if (place.y > 0.01f) continue;
                const size_t part = place.x < kMirrorEnd ? 0 : place.x < kWaterBegin ? 1 : 2;
                const glm::vec3 apart = glm::abs(glm::vec3(moving.light[at] - still.light[at]));
                off[part] += double(apart.r + apart.g + apart.b);
                sum[part] += double(still.light[at].r + still.light[at].g + still.light[at].b);
            }
        }
        return {off[0] / sum[0], off[1] / sum[1], off[2] / sum[2]};
    }
};

TEST_F(ReflectionPath, HasTheLightOfAStillCamera) {
    const scene::Scene scene = stage();
    const std::unique_ptr<render::Session> moving = begin(scene), still = begin(scene);
    ASSERT_TRUE(moving && still);
    const int every = std::getenv("WEFT_EXTENDED") != nullptr ? 1 : 6;
    for (int i = 0; i < kPathFrames; ++i) {
        const Frame frame = draw_from(*moving, camera_at(i));
        if (i % every != every - 1) continue;
        const PartErrors found = errors_of(frame, draw_from(*still, camera_at(i), kStillFrames));
        std::printf("frame %d: mirror %.4f, rough floor %.4f, water %.4f\n", i, found.mirror, found.rough,
                    found.water);
        if (i == 0) continue;  // There is no previous picture yet, so nothing is mirrored.
        EXPECT_LE(found.mirror, 0.12);
        EXPECT_LE(found.rough, 0.1);
        EXPECT_LE(found.water, 0.1);
    }
}

}  // namespace
}  // namespace weft::test

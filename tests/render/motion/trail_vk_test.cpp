// Tests that an object which moves in front of a still wall leaves no trail: eight frames after it has
// uncovered the wall, temporal anti-aliasing shows nothing of the object there. The wall has a pattern of
// high contrast, so that clipping the history to the colours of the neighbour pixels would not remove the
// trail.
#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kTrailSize{96, 64, 1};
constexpr int kFramesHidden = 20, kFramesSeen = 8;
constexpr double kFrame_s = 1.0 / 60;

scene::Mesh rectangle(float half_width_m, float half_height_m) {
    scene::Mesh mesh;
    const float x = half_width_m, y = half_height_m;
    mesh.positions = {{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.tangents.assign(4, {1, 0, 0, 1});
    mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.bounds = {{-x, -y, 0}, {x, y, 0}};
    return mesh;
}

// Stripes of 0.15 m before a dark wall, and a red square that moves by 3 m per second before them.
scene::Scene scene_with_square(bool visible) {
    scene::Scene scene;
    scene.meshes = {rectangle(6, 4), rectangle(0.075f, 4), rectangle(0.6f, 0.6f)};
    scene.materials.resize(3);
    for (const size_t i : {0u, 1u, 2u}) scene.materials[i].roughness = 1;
    scene.materials[0].base_color = {0.1f, 0.1f, 0.1f, 1};
    scene.materials[1].base_color = {0.8f, 0.8f, 0.8f, 1};
    scene.materials[2].base_color = {0.9f, 0.1f, 0.1f, 1};
    scene.instances.push_back({"wall", 0, 0});
    for (int i = -20; i <= 20; ++i)
        scene.instances.push_back(
            {"stripe", 1, 1, glm::translate(glm::mat4(1), glm::vec3(0.3f * float(i), 0, 0.01f))});
    scene.motion.nodes = {{}};
    scene::Animation animation;
    animation.length_s = 10;
    animation.samplers = {
        {scene::Interpolation::linear, false, {0, 10}, {{-1.5f, 0, 0.5f, 0}, {28.5f, 0, 0.5f, 0}}}};
    animation.channels = {{0, scene::MotionPath::translation, 0}};
    scene.motion.animations = {animation};
    if (visible) scene.instances.push_back({"square", 2, 2, glm::mat4(1), 0});
    scene::Light light;
    light.type = scene::LightType::directional;
    light.direction = glm::normalize(glm::vec3(0, -0.2f, -1));
    light.intensity = 3;
    scene.lights = {light};
    scene.bounds = scene::world_bounds(scene);
    return scene;
}

class Trail : public SessionTest {
 protected:
    struct Frame {
        std::vector<glm::vec4> hdr, resolved;
    };
    std::unique_ptr<render::Session> begin(bool visible) {
        scene::Camera camera;
        camera.transform = glm::translate(glm::mat4(1), {0, 0, 5});
        camera.fov_y_rad = 0.7f;
        return start(scene_with_square(visible), camera, graph_path("taa"), kTrailSize, {"hdr", "resolved"});
    }
    static Frame draw(render::Session& session, int frame) {
        EXPECT_TRUE(draw_frame(session, frame * kFrame_s));
        EXPECT_TRUE(session.finish());
        Frame out;
        for (const vk::ReadbackData& data : session.take_readbacks())
            (data.pass == "observe:hdr" ? out.hdr : out.resolved) =
                render::decode_texels(data.format, data.bytes);
        return out;
    }
};

TEST_F(Trail, IsGoneEightFramesAfterTheWallIsUncovered) {
    const std::unique_ptr<render::Session> moving = begin(true), empty = begin(false);
    ASSERT_TRUE(moving && empty);
    std::vector<Frame> seen, wall;
    for (int i = 0; i < kFramesHidden + kFramesSeen; ++i) {
        seen.push_back(draw(*moving, i));
        // Without the square, the mean begins again when the wall is uncovered. So both means have the same
        // frames.
        frame_of(*empty).camera_cut = i == kFramesHidden;
        wall.push_back(draw(*empty, i));
    }
    double trail = 0, square = 0;
    int pixels = 0;
    for (size_t i = 0; i < wall[0].hdr.size(); ++i) {
        const auto differs = [&](int frame) {
            const size_t f = size_t(frame);
            return glm::distance(glm::vec3(seen[f].hdr[i]), glm::vec3(wall[f].hdr[i])) > 1e-3f;
        };
        if (!differs(kFramesHidden - 1)) continue;
        bool uncovered = true;
        for (int frame = kFramesHidden; frame < kFramesHidden + kFramesSeen; ++frame)
            uncovered &= !differs(frame);
        if (!uncovered) continue;
        ++pixels;
        trail += glm::distance(glm::vec3(seen.back().resolved[i]), glm::vec3(wall.back().resolved[i]));
        square += glm::distance(glm::vec3(seen[kFramesHidden - 1].hdr[i]),
                                glm::vec3(wall[kFramesHidden - 1].hdr[i]));
    }
    std::printf("%d pixels were uncovered; after %d frames, %.4f of the square is left\n", pixels,
                kFramesSeen, trail / square);
    EXPECT_GE(pixels, 20);
    EXPECT_LE(trail, 0.005 * square);
}

}  // namespace
}  // namespace weft::test

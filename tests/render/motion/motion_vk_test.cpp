// Purpose: tests that moving objects are drawn at their place, that the velocity buffer contains the motion
// of the object and of the camera, and that passes at rest wake only while something moves.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kSize{48, 48, 1};

scene::Mesh square() {
    scene::Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.tangents.assign(4, {1, 0, 0, 1});
    mesh.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.bounds = {{-1, -1, 0}, {1, 1, 0}};
    return mesh;
}

// A square at the origin that moves by (1, 0.5, -1) per second and turns about z by 90 degrees per second,
// for two seconds. In the third second it does not move. A second square further back never moves. Both face
// the camera.
scene::Scene moving_scene() {
    scene::Scene scene;
    scene.meshes = {square()};
    scene.materials = {{}};
    scene.materials[0].double_sided = false;
    scene.motion.nodes = {{}};
    scene::Animation animation;
    animation.length_s = 3;
    const float h = std::sqrt(0.5f);
    animation.samplers = {
        {scene::Interpolation::linear, false, {0, 2}, {glm::vec4(0), {2, 1, -2, 0}}},
        {scene::Interpolation::linear, true, {0, 1, 2}, {{0, 0, 0, 1}, {0, 0, h, h}, {0, 0, 1, 0}}},
        {scene::Interpolation::step, false, {0, 3}, {glm::vec4(1), glm::vec4(1)}}};
    animation.channels = {{0, scene::MotionPath::translation, 0},
                          {0, scene::MotionPath::rotation, 1},
                          {0, scene::MotionPath::scale, 2}};
    scene.motion.animations = {animation};
    scene.instances = {{"moves", 0, 0, glm::mat4(1), 0},
                       {"stays", 0, 0, glm::translate(glm::mat4(1), {-2, -2, -4})}};
    scene.bounds = scene::world_bounds(scene);
    return scene;
}

scene::Camera front_camera() {
    scene::Camera camera;
    camera.transform = glm::translate(glm::mat4(1), {0.5f, 0.25f, 6});
    return camera;
}

class MotionTest : public SessionTest {
 protected:
    struct Frame {
        std::vector<glm::vec4> velocity, albedo;
        shared::ViewConstants view;
    };
    static Frame frame(render::Session& session, double time_s) {
        EXPECT_TRUE(draw_frame(session, time_s));
        EXPECT_TRUE(session.finish());
        Frame out;
        for (const vk::ReadbackData& data : session.take_readbacks())
            (data.pass == "observe:velocity" ? out.velocity : out.albedo) =
                render::decode_texels(data.format, data.bytes);
        out.view = session.parts().frames.view();
        return out;
    }

    // Compares the velocity of every texel with the one that follows from the two transforms of the objects,
    // computed on the CPU. Returns the number of texels that show the moving object.
    static int compare(const Frame& frame, const glm::mat4& now, const glm::mat4& before) {
        int seen = 0;
        for (uint32_t y = 0; y < kSize.height; ++y) {
            for (uint32_t x = 0; x < kSize.width; ++x) {
                const glm::vec2 uv((static_cast<float>(x) + 0.5f) / static_cast<float>(kSize.width),
                                   (static_cast<float>(y) + 0.5f) / static_cast<float>(kSize.height));
                const glm::mat4 away = glm::translate(glm::mat4(1), {-2, -2, -4});
                const std::optional<glm::vec3> near = hit(frame.view, uv, now),
                                               far = hit(frame.view, uv, away);
                if (on_edge(frame.view, uv, now) || on_edge(frame.view, uv, away)) continue;
                if (!near && !far) continue;
                const glm::mat4& old = near ? before : away;
                const glm::vec4 local((near ? *near : *far), 1);
                const glm::vec4 clip = frame.view.prev_view_projection * (old * local);
                const glm::vec2 wanted = uv - frame.view.jitter_uv - (glm::vec2(clip) / clip.w * 0.5f + 0.5f);
                const glm::vec2 found(frame.velocity[y * kSize.width + x]);
                EXPECT_LE(glm::length(found - wanted), 0.002f + 0.002f * glm::length(wanted))
                    << x << ", " << y << ": found " << found.x << ", " << found.y << "; wanted " << wanted.x
                    << ", " << wanted.y;
                seen += near ? 1 : 0;
            }
        }
        return seen;
    }

 private:
    // Returns the point of the square, in its own space, that a texel shows; nullopt if it shows none.
    static std::optional<glm::vec3> hit(const shared::ViewConstants& view, glm::vec2 uv,
                                        const glm::mat4& world) {
        const glm::dmat4 inverse = glm::inverse(glm::dmat4(view.view_projection) * glm::dmat4(world));
        const glm::dvec2 clip = glm::dvec2(uv) * 2.0 - 1.0;
        const auto at = [&](double depth) {
            const glm::dvec4 point = inverse * glm::dvec4(clip, depth, 1);
            return glm::dvec3(point) / point.w;
        };
        const glm::dvec3 a = at(0.9), b = at(0.01);
        const glm::dvec3 p = a + (b - a) * (a.z / (a.z - b.z));
        if (std::abs(p.x) > 1 || std::abs(p.y) > 1) return std::nullopt;
        return glm::vec3(p);
    }
    static bool on_edge(const shared::ViewConstants& view, glm::vec2 uv, const glm::mat4& world) {
        const float d = 1.0f / static_cast<float>(kSize.width);
        const bool here = hit(view, uv, world).has_value();
        for (const glm::vec2 step : {glm::vec2(d, 0), glm::vec2(-d, 0), glm::vec2(0, d), glm::vec2(0, -d)})
            if (hit(view, uv + step, world).has_value() != here) return true;
        return false;
    }
};

TEST_F(MotionTest, TheVelocityBufferContainsTheMotionOfTheObject) {
    const scene::Scene scene = moving_scene();
    const std::unique_ptr<render::Session> session =
        start(scene, front_camera(), kDeferredGraph, kSize, {"velocity", "albedo"});
    ASSERT_TRUE(session);
    const auto at = [&](double t) { return scene::transforms_at(scene.motion, t)[0]; };
    EXPECT_GT(compare(frame(*session, 0.5), at(0.5), at(0.5)), 50) << "the first frame has no motion";
    EXPECT_GT(compare(frame(*session, 0.75), at(0.75), at(0.5)), 50);
    frame_of(*session).camera.transform[3].x += 0.3f;
    EXPECT_GT(compare(frame(*session, 1.25), at(1.25), at(0.75)), 50) << "the camera moves, too";
    EXPECT_GT(compare(frame(*session, 2.25), at(2.25), at(1.25)), 50);
    EXPECT_GT(compare(frame(*session, 2.5), at(2.25), at(2.25)), 50) << "the object stands";
    EXPECT_GT(compare(frame(*session, 3.5), at(0.5), at(2.5)), 50) << "the animation repeats";
}

TEST_F(MotionTest, ALongRunOfFramesIsRightWithoutWaitingForEach) {
    const scene::Scene scene = moving_scene();
    const std::unique_ptr<render::Session> session =
        start(scene, front_camera(), kDeferredGraph, kSize, {"velocity", "albedo"});
    ASSERT_TRUE(session);
    for (int i = 0; i < 6; ++i) ASSERT_TRUE(draw_frame(*session, 0.2 * i));
    ASSERT_TRUE(session->finish());
    std::vector<vk::ReadbackData> all = session->take_readbacks();
    Frame last;
    for (const vk::ReadbackData& data : all)
        if (data.pass == "observe:velocity") last.velocity = render::decode_texels(data.format, data.bytes);
    last.view = session->parts().frames.view();
    EXPECT_GT(
        compare(last, scene::transforms_at(scene.motion, 1)[0], scene::transforms_at(scene.motion, 0.8)[0]),
        50);
}

TEST_F(MotionTest, AnObjectThatIsMirroredForATimeKeepsItsFront) {
    scene::Scene scene = moving_scene();
    scene.instances.pop_back();
    // From time 1 on, the scale along x is -1. Without the flip of the winding the square would be culled.
    scene.motion.animations[0].samplers[2] = {
        scene::Interpolation::step, false, {0, 1, 3}, {glm::vec4(1), glm::vec4(-1, 1, 1, 0), glm::vec4(1)}};
    const std::unique_ptr<render::Session> session =
        start(scene, front_camera(), kDeferredGraph, kSize, {"velocity", "albedo"});
    ASSERT_TRUE(session);
    const auto drawn = [&](double t) {
        const Frame f = frame(*session, t);
        return std::ranges::count_if(f.albedo, [](const glm::vec4& c) { return c.r > 0.5f; });
    };
    EXPECT_GT(drawn(0.5), 50);
    EXPECT_GT(drawn(1.5), 50);
    EXPECT_GT(drawn(3.5), 50);
}

TEST_F(MotionTest, LampsAndCamerasMoveWithTheirNode) {
    scene::Scene scene = moving_scene();
    scene::Light lamp;
    lamp.node = 0;
    lamp.intensity = 100;
    scene.lights = {lamp};
    scene::Camera camera = front_camera();
    camera.node = 0;
    const std::unique_ptr<render::Session> session =
        start(scene, camera, kDeferredGraph, kSize, {"velocity", "albedo"});
    ASSERT_TRUE(session);
    (void)frame(*session, 0);
    (void)frame(*session, 1);
    const glm::mat4 world = scene::transforms_at(scene.motion, 1)[0];
    EXPECT_LE(glm::distance(session->parts().scene.lights().at(0).position, glm::vec3(world[3])), 1e-5f);
    const shared::ViewConstants& view = session->parts().frames.view();
    EXPECT_LE(glm::distance(view.eye, glm::vec3(world[3])), 1e-5f);
    EXPECT_LE(glm::length(view.view * world[3] - glm::vec4(0, 0, 0, 1)), 1e-5f);
}

// The scene of rest.json has a pass "shape" that draws the list "opaque", and passes that draw nothing.
TEST_F(MotionTest, PassesAtRestWakeOnlyWhileSomethingMoves) {
    const scene::Scene scene = moving_scene();
    const std::unique_ptr<render::Session> session =
        start(scene, front_camera(), WEFT_SOURCE_DIR "/tests/render/rest/rest.json", kSize, {});
    ASSERT_TRUE(session);
    const auto woken = [&](double t) {
        EXPECT_TRUE(draw_frame(*session, t));
        EXPECT_TRUE(session->finish());
        std::set<std::string> ran;
        for (const vk::FrameTiming& timing : session->take_timings())
            for (const vk::PassTiming& pass : timing.passes)
                if (!pass.woken_by.empty()) ran.insert(pass.pass);
        return ran;
    };
    (void)woken(0);
    EXPECT_TRUE(woken(0).empty());
    EXPECT_EQ(woken(0.5), std::set<std::string>{"shape"});
    EXPECT_EQ(woken(1), std::set<std::string>{"shape"});
    EXPECT_EQ(woken(2), std::set<std::string>{"shape"});
    EXPECT_EQ(woken(2.2), std::set<std::string>{"shape"}) << "the velocity becomes 0";
    EXPECT_TRUE(woken(2.4).empty());
    EXPECT_TRUE(woken(2.9).empty());
    EXPECT_EQ(woken(3.5), std::set<std::string>{"shape"});
}

}  // namespace
}  // namespace weft::test

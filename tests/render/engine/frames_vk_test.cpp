// Purpose: tests that a program moves instances, lights and parameters from frame to frame, that velocities,
// boxes and shadow maps follow, and that passes at rest run only if what they read has changed.
#include "tests/render/engine/engine_fixture.h"

namespace weft::test {
namespace {

// The first square moves along a path in the first two of three seconds, as a node of the scene.
scene::Scene scene_with_node() {
    scene::Scene scene = squares({{"moves", 0, 0, glm::mat4(1), 0}, {"stays", 0, 0, moved(-2, -1, -4)}});
    scene.motion.nodes = {{}};
    scene::Animation animation;
    animation.length_s = 3;
    animation.samplers = {
        {scene::Interpolation::linear, false, {0, 2, 3}, {glm::vec4(0), {2, 1, -2, 0}, {2, 1, -2, 0}}}};
    animation.channels = {{0, scene::MotionPath::translation, 0}};
    scene.motion.animations = {animation};
    return scene;
}

class EngineFrames : public EngineTest {};

TEST_F(EngineFrames, AnInstanceThatTheProgramMovesLooksLikeOneThatFollowsANode) {
    const scene::Scene with_node = scene_with_node();
    scene::Scene without = with_node;
    without.motion = {};
    without.instances[0].node = scene::kNone;
    const auto reference = open(with_node, false), session = open(without, true);
    ASSERT_TRUE(reference && session);
    std::set<std::string> woken;
    for (const double time : {0.0, 0.25, 0.5, 0.5, 0.5, 0.5, 1.5, 2.25, 2.5, 2.75}) {
        const glm::mat4 transform = scene::transforms_at(with_node.motion, time)[0];
        frame_of(*session).transforms = {{0, transform}};
        const EngineFrame wanted = render_one(*reference, time), found = render_one(*session, time);
        // The shadow map depends on the box of the scene, which includes a margin for each moving object.
        for (const std::string& image : kEngineObserved)
            EXPECT_TRUE(image == "shadow" || found.images.at(image) == wanted.images.at(image))
                << image << " at " << time;
        EXPECT_EQ(found.woken, wanted.woken) << time;
        woken.insert(found.woken.begin(), found.woken.end());
    }
    EXPECT_TRUE(woken.contains("outline"));
}

TEST_F(EngineFrames, TheShadowMapsOfTheSunFollowMovedInstances) {
    const scene::Scene scene = squares({{"a", 0, 0, moved(0, 0, -1)}, {"stays", 0, 0, glm::mat4(1)}});
    const auto session = open(scene, true);
    ASSERT_TRUE(session);
    render_one(*session);
    const glm::dvec2 near_m = session->parts().frames.sun().cascades[0].rect.size();
    frame_of(*session).transforms = {{0, moved(3, 0, -30)}};
    render_one(*session);
    ASSERT_EQ(session->parts().frames.sun().count, 1u);
    const glm::dvec2 far_m = session->parts().frames.sun().cascades[0].rect.size();
    EXPECT_GT(glm::length(far_m), 1.5 * glm::length(near_m));
    const std::optional<scene::Bounds> bounds = session->parts().scene.gpu().bounds();
    ASSERT_TRUE(bounds);
    EXPECT_NEAR(bounds->max.x, 4, 0.01);
    EXPECT_NEAR(bounds->min.z, -30, 0.01);
}

TEST_F(EngineFrames, ATransformStaysUntilTheNextOne) {
    const scene::Scene scene = squares({{"a", 0, 0, moved(20, 0, 0)}, {"b", 0, 0, moved(-2, -1, -4)}});
    const auto session = open(scene, true);
    ASSERT_TRUE(session);
    const std::vector<std::byte> empty = render_one(*session).images["place"];
    frame_of(*session).transforms = {{0, moved(1, 0, 0)}};
    const EngineFrame first = render_one(*session);
    const std::vector<glm::vec4> place = texels(first, "place"), past = texels(first, "past");
    uint32_t seen = 0;
    for (size_t i = 0; i < place.size(); ++i) {
        if (place[i].w == 0) continue;
        // The square behind, at z = -4, has not moved.
        EXPECT_NEAR(past[i].x - place[i].x, place[i].z < -3 ? 0 : 19, 1e-4);
        seen += place[i].z < -3 ? 0 : 1;
    }
    EXPECT_GT(seen, 20u);
    const EngineFrame still = render_one(*session);
    EXPECT_TRUE(still.images.at("place") != empty) << "the square has moved into the picture";
    EXPECT_TRUE(still.woken.contains("outline")) << "the previous transform has changed";
    frame_of(*session).transforms.clear();
    for (int i = 0; i < 3; ++i) {
        const EngineFrame next = render_one(*session);
        EXPECT_TRUE(next.images.at("place") == still.images.at("place")) << i;
        EXPECT_TRUE(next.images.at("past") == still.images.at("past")) << i;
        EXPECT_EQ(next.woken, std::set<std::string>()) << i;
    }
}

TEST_F(EngineFrames, AnInstanceThatCannotMoveIsReported) {
    const scene::Scene scene = scene_with_node();
    const auto fixed = open(scene, false), session = open(scene, true);
    ASSERT_TRUE(fixed && session);
    frame_of(*fixed).transforms = {{1, moved(1, 0, 0)}};
    EXPECT_EQ(code_of(draw_frame(*fixed)), "W244");
    for (const render::InstanceTransform& wrong : {render::InstanceTransform{0}, render::InstanceTransform{2},
                                                   render::InstanceTransform{1, moved(0, 0, 0), 7}}) {
        frame_of(*session).transforms = {wrong};
        EXPECT_EQ(code_of(draw_frame(*session)), "W244");
    }
    frame_of(*session).transforms = {{1, moved(1, 0, 0)}};
    EXPECT_TRUE(draw_frame(*session)) << "the session goes on after the error";
}

TEST_F(EngineFrames, TheLightsOfAFrameReplaceThoseOfTheScene) {
    const auto session = open(squares({{"a", 0, 0, glm::mat4(1)}}), false);
    ASSERT_TRUE(session);
    const EngineFrame first = render_one(*session);
    EXPECT_EQ(texels(first, "seen")[0], glm::vec4(1, 1, 0, 0));
    scene::Light lamp;
    lamp.position = {1, 2, 3};
    std::vector<scene::Light> lights(6, lamp);
    lights[1].position = {4, 5, 6};
    frame_of(*session).lights = lights;
    EngineFrame frame = render_one(*session);
    EXPECT_EQ(texels(frame, "seen")[0], glm::vec4(6, 0, 0, 0)) << "more lights than the buffer holds";
    EXPECT_EQ(texels(frame, "seen")[1], glm::vec4(1, 2, 3, 1));
    EXPECT_EQ(texels(frame, "seen")[2], glm::vec4(4, 5, 6, 1));
    EXPECT_EQ(frame.woken, std::set<std::string>()) << "the pass at rest reads no lights";
    EXPECT_EQ(session->parts().frames.sun().count, 0u) << "there is no sun";
    frame_of(*session).lights->clear();
    EXPECT_EQ(texels(render_one(*session), "seen")[0], glm::vec4(0));
    frame_of(*session).lights.reset();
    frame = render_one(*session);
    EXPECT_TRUE(frame.images.at("seen") == first.images.at("seen"));
    EXPECT_TRUE(frame.images.at("shadow") == first.images.at("shadow"));
}

TEST_F(EngineFrames, AParameterOfAFrameNeedsNoNewPlan) {
    const auto session = open(squares({{"a", 0, 0, glm::mat4(1)}}), false);
    ASSERT_TRUE(session);
    const FramePlan* plan = &session->plan();
    render_one(*session);
    frame_of(*session).parameters = {{"share", 1}};
    EngineFrame frame = render_one(*session);
    EXPECT_TRUE(frame.images.at("trail") == frame.images.at("place")) << "only the new place counts";
    frame_of(*session).parameters = {{"share", 0}};
    const std::vector<std::byte> before = frame.images.at("trail");
    frame_of(*session).camera.transform = moved(0, 0, 5);
    frame = render_one(*session);
    EXPECT_TRUE(frame.images.at("trail") == before) << "only the old places count";
    EXPECT_EQ(&session->plan(), plan);
    EXPECT_EQ(session->pipelines_made_between_frames(), 0u);
    for (const render::ParameterValues& wrong :
         {render::ParameterValues{{"copies", 2}}, {{"shares", 1}}, {{"share", 2}}}) {
        frame_of(*session).parameters = wrong;
        EXPECT_EQ(code_of(draw_frame(*session)), "W242");
    }
    frame_of(*session).parameters.clear();
    EXPECT_TRUE(render_one(*session).images.at("trail") == before) << "a value stays";
}

}  // namespace
}  // namespace weft::test

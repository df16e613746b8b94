// Purpose: tests that parts of a scene are added and removed while frames run: the picture is that of one
// scene with all objects, frames in flight keep what they draw, and no frame allocates memory or waits.
#include "tests/render/engine/engine_run.h"
#include "weft/vulkan/native.h"

namespace weft::test {
namespace {

scene::Scene joined(scene::Scene base, const scene::Scene& part) {
    const auto first_material = static_cast<uint32_t>(base.materials.size());
    const auto first_mesh = static_cast<uint32_t>(base.meshes.size());
    base.meshes.insert(base.meshes.end(), part.meshes.begin(), part.meshes.end());
    base.textures = part.textures;
    base.materials.insert(base.materials.end(), part.materials.begin(), part.materials.end());
    for (scene::Instance instance : part.instances) {
        instance.mesh += first_mesh;
        instance.material += first_material;
        base.instances.push_back(instance);
    }
    base.bounds = scene::world_bounds(base);
    return base;
}

TEST_F(Streaming, APartLooksLikeObjectsOfTheScene) {
    const scene::Scene part = part_scene(0.5f);
    const auto session = open(base_scene(), false), whole = open(joined(base_scene(), part), false);
    ASSERT_TRUE(session && whole);
    const EngineFrame before = render_one(*session), wanted = render_one(*whole);
    EXPECT_EQ(render_one(*session).woken, std::set<std::string>());
    const render::PartId id = add(*session, part);
    EngineFrame frame = render_one(*session);
    for (const char* image : {"place", "past", "glass"})
        EXPECT_TRUE(frame.images.at(image) == wanted.images.at(image)) << image;
    EXPECT_FALSE(frame.images.at("glass") == before.images.at("glass"));
    EXPECT_EQ(frame.woken, std::set<std::string>{"outline"});
    EXPECT_EQ(render_one(*session).woken, std::set<std::string>());
    ASSERT_TRUE(session->remove_part(id));
    frame = render_one(*session);
    for (const char* image : {"place", "past", "glass"})
        EXPECT_TRUE(frame.images.at(image) == before.images.at(image)) << image;
    EXPECT_EQ(frame.woken, std::set<std::string>{"outline"});
    EXPECT_EQ(code_of(session->remove_part(id)), "W247") << "it is removed already";
    EXPECT_EQ(code_of(session->remove_part(render::kFirstPart)), "W247");
}

TEST_F(Streaming, TheProgramMovesTheInstancesOfAPart) {
    const auto session = open(base_scene(), false), whole = open(joined(base_scene(), part_scene(1)), false);
    ASSERT_TRUE(session && whole);
    const EngineFrame wanted = render_one(*whole);
    const render::PartId id = add(*session, part_scene(30), true);
    render_one(*session);
    frame_of(*session).transforms = {{0, moved(1, 0.5f, -1), id}, {1, moved(1, 0, 1), id}};
    EngineFrame frame;
    for (int i = 0; i < 3; ++i) frame = render_one(*session);
    for (const char* image : {"place", "past", "glass"})
        EXPECT_TRUE(frame.images.at(image) == wanted.images.at(image)) << image;
    ASSERT_TRUE(session->remove_part(id));
    EXPECT_EQ(code_of(draw_frame(*session)), "W244") << "the part is gone";
}

TEST_F(Streaming, APartThatIsNeverDrawnIsDestroyed) {
    const auto session = open(base_scene(), false);
    ASSERT_TRUE(session);
    {
        const Result<render::ScenePart> unused = session->prepare_part(part_scene(0));
        EXPECT_TRUE(unused);
    }
    const render::PartId removed = add(*session, part_scene(0));
    EXPECT_TRUE(session->remove_part(removed));
    (void)add(*session, part_scene(0));
}

// The session runs on a device that Weft has adopted, and whose program has locks for its queues.
TEST_F(Streaming, ThePartIsSubmittedUnderTheLockOfTheProgram) {
    const std::unique_ptr<vk::Device> own = std::move(device_);
    const vk::NativeDevice handles = native(*own);
    vk::FeatureChain supported, enabled;
    own->instance_fn().vkGetPhysicalDeviceFeatures2(own->physical(), &supported.head());
    vk::enable_features(supported, enabled);
    uint32_t locks = 0, unlocks = 0;
    vk::EmbedderCallbacks callbacks;
    callbacks.lock_queue = [&](VkQueue) { ++locks; };
    callbacks.unlock_queue = [&](VkQueue) { ++unlocks; };
    Result<std::unique_ptr<vk::Device>> adopted = vk::Device::adopt(
        {handles.instance, handles.physical, handles.device, {handles.queue}, &enabled, callbacks});
    ASSERT_TRUE(adopted) << to_text(adopted.errors());
    device_ = std::move(*adopted);
    auto session = open(base_scene(), false);
    ASSERT_TRUE(session);
    render_one(*session);
    const uint32_t before = locks;
    (void)add(*session, part_scene(0));
    EXPECT_EQ(locks, before + 1);
    EXPECT_EQ(unlocks, locks);
    render_one(*session);
    session.reset();
    device_.reset();
    for (const vk::Message& m : own->messages().messages()) ADD_FAILURE() << m.id << ": " << m.text;
}

class EngineRun : public EngineRunTest {
 protected:
    // Compares a run that streams parts with one that does not.
    void expect_steady() {
        const LongRun plain = run({.end = frame_count()});
        const LongRun streamed = run({.end = frame_count(), .streams = true});
        EXPECT_GE(streamed.parts, frame_count() / 6 - 2);
        EXPECT_EQ(streamed.counts.allocations, 0);
        EXPECT_EQ(streamed.counts.idle_waits, 0);
        EXPECT_EQ(streamed.counts.pipelines, 0);
        EXPECT_EQ(streamed.counts.command_pools, 0) << "no new session";
        EXPECT_EQ(streamed.counts.submissions, plain.counts.submissions + streamed.parts)
            << "each part is one submission";
        uint32_t compared = 0;
        for (const auto& [name, bytes] : plain.images) {
            if (name.starts_with("observe:shadow")) continue;  // The box of the scene contains the parts.
            ++compared;
            ASSERT_TRUE(streamed.images.contains(name)) << name;
            EXPECT_TRUE(streamed.images.at(name) == bytes) << name;
        }
        EXPECT_GT(compared, 40u);
    }
};

class EngineRunOnQueues : public EngineRun {
 protected:
    EngineRunOnQueues() { queues_ = 3; }
};

TEST_F(EngineRun, NoFrameAllocatesOrWaitsAndHistoriesStayWhole) {
    expect_steady();
}

TEST_F(EngineRunOnQueues, NoFrameAllocatesOrWaitsAndHistoriesStayWhole) {
    expect_steady();
}

}  // namespace
}  // namespace weft::test

// Purpose: tests that parts of a scene are added and removed while frames run: the picture is that of one
// scene with all objects, frames in flight keep what they draw, and no frame allocates memory or waits.
#include <cstdlib>
#include <thread>

#include "tests/render/engine/call_counter.h"
#include "tests/render/engine/engine_fixture.h"

namespace weft::test {
namespace {

// A moving opaque square and a transparent one, with a texture.
scene::Scene part_scene(float x) {
    scene::Scene part = squares({{"solid", 0, 0, moved(x, 0.5f, -1)}, {"glass", 0, 1, moved(x, 0, 1)}});
    part.materials[1].base_color = {0.9f, 0.1f, 0.1f, 0.5f};
    part.textures = {{"blue", 1, 1, scene::ColorSpace::linear, {{0, 0, 255, 255}}}};
    part.materials[1].base_color_texture.texture = 0;
    return part;
}

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

scene::Scene base_scene() {
    return squares(
        {{"solid", 0, 0, glm::mat4(1)}, {"glass", 0, 1, moved(-1, 0, 0.5f)}, {"far", 0, 1, moved(0, 0, 2)}});
}

class Streaming : public EngineTest {
 protected:
    static render::PartId add(render::Session& session, const scene::Scene& scene, bool moves = false) {
        Result<render::ScenePart> part = session.prepare_part(scene, moves);
        EXPECT_TRUE(part) << to_text(part.errors());
        const Result<render::PartId> id = session.add_part(std::move(*part));
        EXPECT_TRUE(id) << to_text(id.errors());
        return *id;
    }
};

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

struct LongRun {
    std::map<std::string, std::vector<std::byte>> images;  // The observed images of some frames.
    CallCounts counts;                                     // The calls after the first frames.
    uint32_t parts = 0;                                    // Number of parts that were added.
};

// Moves everything, and streams parts in and out behind the camera.
class EngineRun : public Streaming {
 protected:
    static uint32_t frame_count() { return std::getenv("WEFT_EXTENDED") != nullptr ? 1000 : 60; }

    static void move_all(render::Session& session, uint32_t i) {
        const float t = static_cast<float>(i) * 0.05f;
        render::FrameInput& frame = frame_of(session);
        frame.camera.transform = moved(std::sin(t), 0.5f, 6 + 0.5f * std::cos(t));
        frame.exposure_ev = std::sin(t);
        frame.transforms = {{0, moved(std::cos(t), 0, 0)}};
        if (i % 3 == 0) frame.transforms.push_back({2, moved(0, std::sin(t), 2)});
        frame.parameters["share"] = 0.25f + 0.25f * std::sin(t);
        scene::Light sun = base_scene().lights[0], lamp;
        sun.direction = glm::normalize(glm::vec3(-1, -1, std::sin(t)));
        lamp.position = {std::cos(t), 1, std::sin(t)};
        frame.lights = std::vector<scene::Light>(i % 4, lamp);
        frame.lights->insert(frame.lights->begin(), sun);
    }

    static void keep(render::Session& session, LongRun& out) {
        for (vk::ReadbackData& data : session.take_readbacks())
            if (data.frame_index % (frame_count() / 20) == 0)
                out.images[data.pass + " " + std::to_string(data.frame_index)] = std::move(data.bytes);
    }

    // Prepares parts on a thread of its own, as a program that loads files does.
    LongRun run(bool streams) {
        constexpr uint32_t kWarmUp = 4, kEach = 6;
        LongRun out;
        const auto session = open(base_scene(), true);
        if (!session) return out;
        std::optional<CallCounter> counter;
        std::vector<render::PartId> added;
        for (uint32_t i = 0; i < frame_count(); ++i) {
            if (i == kWarmUp) counter.emplace(*device_);
            if (streams && i > kWarmUp && i % kEach == 0) {
                std::optional<Result<render::ScenePart>> part;
                std::thread loader([&] { part.emplace(session->prepare_part(part_scene(0), true)); });
                loader.join();
                EXPECT_TRUE(*part);
                const Result<render::PartId> id = session->add_part(std::move(**part));
                EXPECT_TRUE(id);
                added.push_back(*id);
                ++out.parts;
            }
            if (streams && added.size() > 2) {
                EXPECT_TRUE(session->remove_part(added.front()));
                added.erase(added.begin());
            }
            move_all(*session, i);
            for (const render::PartId part : added) {
                frame_of(*session).transforms.push_back({0, moved(0, 0, 40 + static_cast<float>(i)), part});
                frame_of(*session).transforms.push_back({1, moved(0, 0, 40), part});
            }
            const Status drawn = draw_frame(*session, 0.02 * i);
            EXPECT_TRUE(drawn) << to_text(drawn.errors());
            keep(*session, out);
        }
        out.counts = counter->counts();
        counter.reset();
        EXPECT_TRUE(session->finish());
        keep(*session, out);
        return out;
    }

    // Compares a run that streams parts with one that does not.
    void expect_steady() {
        const LongRun plain = run(false), streamed = run(true);
        EXPECT_GE(streamed.parts, frame_count() / 6 - 2);
        EXPECT_EQ(streamed.counts.allocations, 0);
        EXPECT_EQ(streamed.counts.idle_waits, 0);
        EXPECT_EQ(streamed.counts.pipelines, 0);
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

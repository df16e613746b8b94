// Purpose: a long run of a session whose program changes everything from frame to frame: it moves the camera,
// the exposure, the lights, the instances and a parameter, and adds and removes parts of the scene.
#pragma once

#include <cstdlib>
#include <thread>

#include "tests/render/engine/call_counter.h"
#include "tests/render/engine/engine_fixture.h"
#include "tests/render/engine/lost_device.h"

namespace weft::test {

// A moving opaque square and a transparent one, with a texture.
inline scene::Scene part_scene(float x) {
    scene::Scene part = squares({{"solid", 0, 0, moved(x, 0.5f, -1)}, {"glass", 0, 1, moved(x, 0, 1)}});
    part.materials[1].base_color = {0.9f, 0.1f, 0.1f, 0.5f};
    part.textures = {{"blue", 1, 1, scene::ColorSpace::linear, {{0, 0, 255, 255}}}};
    part.materials[1].base_color_texture.texture = 0;
    return part;
}

inline scene::Scene base_scene() {
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

// The frames that one session renders.
struct Stretch {
    uint32_t first = 0,
             end = 0;        // The numbers of the frames, from which their cameras, lights and so on follow.
    bool streams = false;    // Adds and removes parts.
    uint32_t held = 0;       // Number of parts that the program has at the start.
    Loss loss = Loss::none;  // The device is lost in the frame `end`.
};

struct LongRun {
    // The observed images of some frames. Key: the name of the readback, and the number of the frame.
    std::map<std::string, std::vector<std::byte>> images;
    std::vector<std::byte> picture;  // The output of the last frame; empty if the device was lost.
    CallCounts counts;               // The calls of the frames after the first ones.
    uint32_t parts = 0;              // Number of parts that were added while frames ran.
    uint32_t held = 0;               // Number of parts that the session had at the end.
};

// Moves everything, and streams parts in and out behind the camera.
class EngineRunTest : public Streaming {
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

    static void keep(render::Session& session, uint32_t first, LongRun& out) {
        for (vk::ReadbackData& data : session.take_readbacks()) {
            const uint64_t frame = first + data.frame_index;
            if (frame % (frame_count() / 20) == 0)
                out.images[data.pass + " " + std::to_string(frame)] = std::move(data.bytes);
        }
    }

    // Prepares the part on a thread of its own, as a program that loads files does.
    static render::PartId load_part(render::Session& session) {
        std::optional<Result<render::ScenePart>> part;
        std::thread loader([&] { part.emplace(session.prepare_part(part_scene(0), true)); });
        loader.join();
        EXPECT_TRUE(*part) << to_text(part->errors());
        const Result<render::PartId> id = session.add_part(std::move(**part));
        EXPECT_TRUE(id) << to_text(id.errors());
        return *id;
    }

    static void move_parts(render::Session& session, const std::vector<render::PartId>& parts, uint32_t i) {
        for (const render::PartId part : parts) {
            frame_of(session).transforms.push_back({0, moved(0, 0, 40 + static_cast<float>(i)), part});
            frame_of(session).transforms.push_back({1, moved(0, 0, 40), part});
        }
    }

    // One session renders all frames of the stretch.
    LongRun run(const Stretch& stretch) {
        constexpr uint32_t kWarmUp = 4, kEach = 6;
        LongRun out;
        auto session = open(base_scene(), true);
        if (!session) return out;
        std::optional<CallCounter> counter;
        std::vector<render::PartId> added;
        while (added.size() < stretch.held) added.push_back(load_part(*session));
        for (uint32_t i = stretch.first; i < stretch.end; ++i) {
            if (i == stretch.first + kWarmUp) counter.emplace(*device_);
            if (stretch.streams && i > stretch.first + kWarmUp && i % kEach == 0) {
                added.push_back(load_part(*session));
                ++out.parts;
            }
            if (added.size() > 2) {
                EXPECT_TRUE(session->remove_part(added.front()));
                added.erase(added.begin());
            }
            move_all(*session, i);
            move_parts(*session, added, i);
            const Status drawn = draw_frame(*session, 0.02 * i);
            EXPECT_TRUE(drawn) << to_text(drawn.errors());
            keep(*session, stretch.first, out);
        }
        out.counts = counter->counts();
        counter.reset();
        out.held = static_cast<uint32_t>(added.size());
        if (stretch.loss != Loss::none) {
            lose(*session, stretch);
            return out;
        }
        EXPECT_TRUE(session->finish());
        keep(*session, stretch.first, out);
        const Result<vk::ReadbackData> picture = session->read_output();
        EXPECT_TRUE(picture) << to_text(picture.errors());
        if (picture) out.picture = picture->bytes;
        return out;
    }

    // Loses the device in the next frame, in which a part has just been added and another one is ready.
    void lose(render::Session& session, const Stretch& stretch) {
        load_part(session);
        Result<render::ScenePart> ready = session.prepare_part(part_scene(0), true);
        EXPECT_TRUE(ready) << to_text(ready.errors());
        lose_device(*device_, stretch.loss);
        move_all(session, stretch.end);
        for (int i = 0; i < 2; ++i) EXPECT_EQ(code_of(draw_frame(session, 0.02 * stretch.end)), "V408");
        EXPECT_EQ(code_of(session.finish()), "V408");
        const Result<render::PartId> late = session.add_part(std::move(*ready));
        ASSERT_FALSE(late);
        EXPECT_EQ(late.errors().front().code, "V408");
    }
};

}  // namespace weft::test

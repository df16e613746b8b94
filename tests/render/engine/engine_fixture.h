// Purpose: test fixture for sessions whose program changes more than the camera from frame to frame.
#pragma once

#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

#include "tests/render/session_fixture.h"

namespace weft::test {

inline constexpr Extent3D kEngineSize{48, 32, 1};
inline const std::string kEngineGraph = WEFT_SOURCE_DIR "/tests/render/engine/engine.json";
inline const std::vector<std::string> kEngineObserved{"place", "past", "glass", "trail", "seen", "shadow"};

// A square from -1 to 1 in the plane z = 0, which faces +z.
inline scene::Mesh square_mesh() {
    scene::Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.tangents.assign(4, {1, 0, 0, 1});
    mesh.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.bounds = {{-1, -1, 0}, {1, 1, 0}};
    return mesh;
}

inline glm::mat4 moved(float x, float y, float z) {
    return glm::translate(glm::mat4(1), {x, y, z});
}

// Squares with an opaque material (0) or a transparent one (1), and the sun.
inline scene::Scene squares(const std::vector<scene::Instance>& instances) {
    scene::Scene scene;
    scene.meshes = {square_mesh()};
    scene.materials.resize(2);
    scene.materials[0].double_sided = scene.materials[1].double_sided = true;
    scene.materials[1].alpha_mode = scene::AlphaMode::blend;
    scene.materials[1].base_color = {0.2f, 0.4f, 0.8f, 0.5f};
    scene.instances = instances;
    scene::Light sun;
    sun.type = scene::LightType::directional;
    sun.direction = glm::normalize(glm::vec3(-1, -1, -1));
    scene.lights = {sun};
    scene.bounds = scene::world_bounds(scene);
    return scene;
}

struct EngineFrame {
    std::map<std::string, std::vector<std::byte>> images;  // Key: name of the observed resource.
    std::set<std::string> woken;                           // The passes with "rest" that ran.
    bool operator==(const EngineFrame&) const = default;
};

class EngineTest : public SessionTest {
 protected:
    static scene::Camera front_camera() {
        scene::Camera camera;
        camera.transform = moved(0.25f, 0.5f, 6);
        return camera;
    }

    render::SessionInput input_for(const std::string& graph, std::vector<std::string> observed) {
        passes_ = registered_passes();
        render::SessionInput input;
        input.request.path = graph;
        input.request.size = kEngineSize;
        input.request.observed = std::move(observed);
        input.load.reader = read_text;
        input.load.reads_disk = true;
        input.load.shader_root = WEFT_SOURCE_DIR "/shaders";
        input.load.shader_cache = WEFT_TEST_CACHE;
        input.passes = &passes_;
        input.check_plan = true;
        input.queues = queues_;
        return input;
    }

    std::unique_ptr<render::Session> open(const scene::Scene& scene, const render::SessionInput& input) {
        Result<std::unique_ptr<render::Session>> session =
            render::Session::create(*device_, scene, input, warnings_);
        EXPECT_TRUE(session) << to_text(session.errors());
        if (!session) return nullptr;
        frame_of(**session) = {.camera = front_camera()};
        return std::move(*session);
    }
    std::unique_ptr<render::Session> open(const scene::Scene& scene, bool moves_instances) {
        render::SessionInput input = input_for(kEngineGraph, kEngineObserved);
        input.moves_instances = moves_instances;
        return open(scene, input);
    }

    // Renders a frame with frame_of(session) and waits for it.
    static EngineFrame render_one(render::Session& session, double time_s = 0) {
        const Status drawn = draw_frame(session, time_s);
        EXPECT_TRUE(drawn) << to_text(drawn.errors());
        EXPECT_TRUE(session.finish());
        EngineFrame frame;
        for (vk::ReadbackData& data : session.take_readbacks())
            frame.images[data.pass.substr(std::string("observe:").size())] = std::move(data.bytes);
        for (const vk::FrameTiming& timing : session.take_timings())
            for (const vk::PassTiming& pass : timing.passes)
                if (!pass.woken_by.empty()) frame.woken.insert(pass.pass);
        return frame;
    }

    static std::vector<glm::vec4> texels(const EngineFrame& frame, const std::string& image) {
        return render::decode_texels(Format::rgba32f, frame.images.at(image));
    }
    // Returns the code of the only error.
    static std::string code_of(const Status& status) {
        EXPECT_FALSE(status);
        if (status) return "";
        EXPECT_EQ(status.errors().size(), 1u) << to_text(status.errors());
        EXPECT_FALSE(status.errors().front().help.empty());
        return status.errors().front().code;
    }
};

}  // namespace weft::test

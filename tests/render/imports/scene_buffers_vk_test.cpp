// Tests the scene buffers on the device: graphs read the bytes that the CPU computes, and a pass that culls
// draws by the boxes changes no pixel.
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "render/frame_data.h"
#include "render/imports/scene_buffers.h"
#include "shared/draw_command.glsl"
#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr const char* kCullGraph = WEFT_SOURCE_DIR "/tests/render/imports/cull.json";

using Bytes = std::map<std::string, std::vector<std::byte>>;

template <class T>
std::vector<T> elements(const std::vector<std::byte>& bytes) {
    std::vector<T> items(bytes.size() / sizeof(T));
    std::memcpy(items.data(), bytes.data(), items.size() * sizeof(T));
    return items;
}

class SceneBuffersVk : public SessionTest {
 protected:
    // Renders one frame and returns the bytes of all observed resources.
    Bytes read(const scene::Scene& scene, const scene::Camera& camera, bool culls,
               std::vector<std::string> observed) {
        Bytes read;
        const std::string text = *read_text(kCullGraph);
        const FileReader reader = [&](const std::string& path) -> std::optional<std::string> {
            if (path != kCullGraph || culls) return read_text(path);
            std::string other = text;
            return other.replace(other.find("\"culls\": true"), 13, "\"culls\": false");
        };
        const std::unique_ptr<render::Session> session =
            start(scene, camera, kCullGraph, {96, 64, 1}, std::move(observed), 0, reader);
        if (!session) return read;
        EXPECT_TRUE(draw_frame(*session));
        EXPECT_TRUE(session->finish());
        for (vk::ReadbackData& data : session->take_readbacks()) read[data.pass] = std::move(data.bytes);
        return read;
    }
};

TEST_F(SceneBuffersVk, GraphsReadWhatTheSceneContains) {
    const Result<scene::Scene> scene = scene::make_builtin("spheres");
    ASSERT_TRUE(scene);
    const Bytes read = this->read(*scene, scene::framing_camera(*scene, 1.5f), true,
                                  {"instances", "bounds", "meshes", "materials", "opaqueCommands"});
    ASSERT_EQ(read.size(), 5u);
    const auto instances = elements<shared::Instance>(read.at("observe:instances"));
    const auto meshes = elements<shared::Mesh>(read.at("observe:meshes"));
    const auto materials = elements<shared::Material>(read.at("observe:materials"));
    ASSERT_EQ(instances.size(), scene->instances.size());
    ASSERT_EQ(meshes.size(), scene->meshes.size());
    ASSERT_EQ(materials.size(), scene->materials.size());
    const std::vector<shared::Bounds> boxes = render::instance_bounds(*scene);
    ASSERT_EQ(read.at("observe:bounds").size(), boxes.size() * sizeof(shared::Bounds));
    EXPECT_EQ(std::memcmp(read.at("observe:bounds").data(), boxes.data(), boxes.size() * sizeof boxes[0]), 0);
    for (size_t i = 0; i < materials.size(); ++i)
        EXPECT_EQ(materials[i].base_color, scene->materials[i].base_color);
    for (size_t i = 0; i < instances.size(); ++i) {
        EXPECT_EQ(instances[i].object_to_world, scene->instances[i].transform);
        EXPECT_EQ(instances[i].mesh, scene->instances[i].mesh);
        EXPECT_EQ(instances[i].material, scene->instances[i].material);
    }
    // A draw command draws the mesh of its instance.
    for (const auto& command : elements<shared::DrawCommand>(read.at("observe:opaqueCommands"))) {
        const shared::Mesh& mesh = meshes.at(instances.at(command.first_instance).mesh);
        EXPECT_EQ(command.index_count, mesh.index_count);
        EXPECT_EQ(command.first_index, mesh.first_index);
        EXPECT_EQ(command.vertex_offset, mesh.vertex_offset);
    }
}

TEST_F(SceneBuffersVk, CullingByTheBoxesChangesNoPixel) {
    const Result<scene::Scene> scene = scene::make_builtin("spheres");
    ASSERT_TRUE(scene);
    std::mt19937 random(2718);
    std::uniform_real_distribution<float> angle(-0.8f, 0.8f);
    size_t left_out = 0, drawn = 0;
    for (int i = 0; i < 6; ++i) {
        scene::Camera camera = scene::framing_camera(*scene, 1.5f);
        camera.transform = camera.transform * glm::rotate(glm::mat4(1), angle(random), glm::vec3(0, 1, 0));
        const Bytes culled = read(*scene, camera, true, {"colour", "depth", "kept"});
        const Bytes all = read(*scene, camera, false, {"colour", "depth", "kept"});
        ASSERT_EQ(culled.size(), 3u);
        EXPECT_EQ(culled.at("observe:colour"), all.at("observe:colour")) << "camera " << i;
        EXPECT_EQ(culled.at("observe:depth"), all.at("observe:depth")) << "camera " << i;
        for (const auto& command : elements<shared::DrawCommand>(culled.at("observe:kept")))
            ++(command.instance_count == 0 ? left_out : drawn);
    }
    std::printf("seed 2718: %zu draws left out, %zu drawn\n", left_out, drawn);
    EXPECT_GT(left_out, 0u);
    EXPECT_GT(drawn, 0u);
}

}  // namespace
}  // namespace weft::test

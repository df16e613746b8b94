// Tests forward shading. It must give the same light as deferred shading for surfaces that both draw, and
// must draw transparent surfaces from the farthest to the nearest, in whatever order the scene has them.
#include <algorithm>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/session_fixture.h"
#include "tests/render/shading/half_steps.h"

namespace weft::test {
namespace {

constexpr Extent3D kForwardSize{320, 180, 1};
constexpr const char* kDeferred = WEFT_SOURCE_DIR "/graphs/deferred.json";
constexpr const char* kForward = WEFT_SOURCE_DIR "/graphs/forward.json";

class Forward : public SessionTest {
 protected:
    std::vector<uint16_t> hdr_of(const scene::Scene& scene, const std::string& graph,
                                 const FileReader& reader) {
        const std::unique_ptr<render::Session> session =
            start(scene, scene.cameras.at(0), graph, kForwardSize, {"hdr"}, scene.exposure_ev, reader);
        if (!session || !draw_frame(*session) || !session->finish()) {
            ADD_FAILURE() << "no picture";
            return {};
        }
        const std::vector<vk::ReadbackData> readbacks = session->take_readbacks();
        std::vector<uint16_t> halves(readbacks.at(0).bytes.size() / sizeof(uint16_t));
        std::memcpy(halves.data(), readbacks[0].bytes.data(), readbacks[0].bytes.size());
        return halves;
    }
};

TEST_F(Forward, SeesWhatDeferredSees) {
    for (const char* name : {"spheres", "atrium", "brushed"}) {
        SCOPED_TRACE(name);
        Result<scene::Scene> scene = scene::make_builtin(name);
        ASSERT_TRUE(scene);
        // Transparent surfaces are removed. Both graphs draw them with the same forward shader, so they would
        // not test the G-buffer.
        std::erase_if(scene->instances, [&](const scene::Instance& i) {
            return scene->materials[i.material].alpha_mode == scene::AlphaMode::blend;
        });
        const std::vector<uint16_t> deferred = hdr_of(*scene, kDeferred, read_text);
        const std::vector<uint16_t> forward = hdr_of(*scene, kForward, read_quantized);
        ASSERT_EQ(deferred.size(), forward.size());
        ASSERT_EQ(deferred.size(), size_t{kForwardSize.width} * kForwardSize.height * 4);
        EXPECT_LE(most_half_steps(name, deferred, forward), 1);
    }
}

// Returns a scene with three transparent panes that face the camera at (0, 0, 4). Each pane emits a different
// colour. The scene lists the nearest pane first if `nearest_first` is true, otherwise last.
scene::Scene panes(bool nearest_first) {
    scene::Scene scene;
    scene::Mesh quad;
    quad.name = "pane";
    quad.positions = {{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}};
    quad.normals.assign(4, {0, 0, 1});
    quad.tangents.assign(4, {1, 0, 0, 1});
    quad.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    quad.indices = {0, 1, 2, 0, 2, 3};
    quad.bounds.min = {-4, -4, 0};
    quad.bounds.max = {4, 4, 0};
    scene.meshes = {quad};
    const std::array<glm::vec3, 3> glow{{{4, 0, 0}, {0, 4, 0}, {0, 0, 4}}};
    for (uint32_t i = 0; i < 3; ++i) {
        scene::Material material;
        material.name = "pane " + std::to_string(i);
        material.base_color = {0, 0, 0, 0.25f};
        material.emissive = glow[i];
        material.specular = 0;
        material.alpha_mode = scene::AlphaMode::blend;
        scene.materials.push_back(material);
        scene::Instance instance;
        instance.material = i;
        // The red pane has z = 0 and is the farthest from the camera.
        instance.transform = glm::translate(glm::mat4(1), glm::vec3(0, 0, static_cast<float>(i)));
        scene.instances.insert(nearest_first ? scene.instances.begin() : scene.instances.end(), instance);
    }
    scene::Camera camera;
    camera.name = "front";
    camera.transform = glm::translate(glm::mat4(1), glm::vec3(0, 0, 4));
    scene.cameras = {camera};
    return scene;
}

TEST_F(Forward, TransparentPanesGoOverOneAnother) {
    for (const bool nearest_first : {false, true}) {
        const scene::Scene scene = panes(nearest_first);
        const std::unique_ptr<render::Session> session =
            start(scene, scene.cameras[0], kForward, {16, 16, 1}, {"hdr"});
        ASSERT_TRUE(session);
        ASSERT_TRUE(draw_frame(*session));
        ASSERT_TRUE(session->finish());
        const std::vector<vk::ReadbackData> readbacks = session->take_readbacks();
        const glm::vec4 center =
            render::decode_texels(readbacks.at(0).format, readbacks[0].bytes)[8 * 16 + 8];
        // Each pane adds a quarter of its own light and lets three quarters of the light behind it through.
        EXPECT_NEAR(center.r, 1 * 0.75 * 0.75, 2e-3) << nearest_first;
        EXPECT_NEAR(center.g, 1 * 0.75, 2e-3) << nearest_first;
        EXPECT_NEAR(center.b, 1, 2e-3) << nearest_first;
    }
}

}  // namespace
}  // namespace weft::test

// Purpose: test fixture for screen-space reflections. It draws several frames with a still camera, and reads
// the images of the last one.
#pragma once

#include "tests/render/session_fixture.h"
#include "tests/render/sun/box_outline.h"
#include "weft/scene/camera_path.h"

namespace weft::test {

// The pictures of the last of several frames.
struct LastFrame {
    // The key is the reference that the test observed.
    std::map<std::string, std::vector<glm::vec4>> images;
    std::vector<glm::vec3> output;  // The final picture, 0 to 1.
    shared::ViewConstants view{};
    float pre_exposure = 1;
};

inline scene::Material emitter(const glm::vec3& radiance) {
    scene::Material material;
    material.base_color = {0, 0, 0, 1};
    material.metallic = 0;
    material.specular = 0;
    material.roughness = 1;
    material.emissive = radiance;
    return material;
}

inline scene::Material metal(float roughness, float albedo = 1) {
    scene::Material material;
    material.base_color = {albedo, albedo, albedo, 1};
    material.metallic = 1;
    material.roughness = roughness;
    return material;
}

inline void add_box(scene::Scene& scene, const glm::vec3& least, const glm::vec3& most,
                    const scene::Material& material) {
    scene.instances.push_back(
        {"box", uint32_t(scene.meshes.size()), uint32_t(scene.materials.size()), glm::mat4(1)});
    scene.meshes.push_back(box_mesh(least, most));
    scene.materials.push_back(material);
    scene.bounds = scene::world_bounds(scene);
}

class ReflectionTest : public SessionTest {
 protected:
    static constexpr const char* kReflectionGraph = WEFT_SOURCE_DIR "/graphs/reflections.json";

    LastFrame draw(const scene::Scene& scene, const scene::Camera& camera, Extent3D size, int frames,
                   std::vector<std::string> observed, const std::string& graph = kReflectionGraph) {
        LastFrame last;
        const std::unique_ptr<render::Session> session =
            start(scene, camera, graph, size, std::move(observed));
        if (!session) return last;
        // A fixed exposure: otherwise the eye still adapts.
        frame_of(*session).parameters["autoExposure"] = 0;
        for (int i = 0; i < frames; ++i) EXPECT_TRUE(draw_frame(*session));
        EXPECT_TRUE(session->finish());
        for (const vk::ReadbackData& data : session->take_readbacks())
            last.images[data.pass.substr(std::string("observe:").size())] =
                render::decode_texels(data.format, data.bytes);
        const Result<vk::ReadbackData> output = session->read_output();
        EXPECT_TRUE(output);
        for (size_t i = 0; output && i < output->bytes.size(); i += 4) {
            glm::vec3 color;
            for (int channel = 0; channel < 3; ++channel)
                color[channel] = float(std::to_integer<int>(output->bytes[i + size_t(channel)])) / 255;
            last.output.push_back(color);
        }
        last.view = session->parts().frames.view();
        last.pre_exposure = session->pre_exposure();
        return last;
    }
};

// Returns the place that a pixel shows. `depth`: reversed, above 0.
inline glm::vec3 place_at(const shared::ViewConstants& view, int x, int y, float depth) {
    const glm::vec4 ndc((float(x) + 0.5f) * view.inverse_viewport.x * 2 - 1,
                        (float(y) + 0.5f) * view.inverse_viewport.y * 2 - 1, depth, 1);
    const glm::vec4 world = view.inverse_view_projection * ndc;
    return glm::vec3(world) / world.w;
}

}  // namespace weft::test

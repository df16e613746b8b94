// Tests that white surfaces of every roughness reflect all light of white surroundings, as metal and as a
// dielectric, with deferred and with forward shading.
#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/shading/ambient_fixture.h"

namespace weft::test {
namespace {

// Steps of 0.1, and values that are neither texels of the table nor mips of the cube.
constexpr std::array kFurnaceRoughness{0.0f,  0.1f,  0.2f,  0.3f,  0.4f,  0.5f,  0.6f,
                                       0.7f,  0.8f,  0.9f,  1.0f,  0.03f, 0.05f, 0.07f,
                                       0.15f, 0.23f, 0.37f, 0.55f, 0.73f, 0.85f, 0.97f};
constexpr int kFurnaceColumns = 7, kFurnaceRows = 6;

// Rows of spheres: three rows of metal, then three rows of a dielectric.
scene::Scene white_spheres() {
    Result<scene::Scene> spheres = scene::make_builtin("spheres");
    scene::Scene scene;
    if (!spheres) return scene;
    scene.meshes = {spheres->meshes.at(0)};
    scene.environment = picture_of([](const glm::dvec3&) { return 1; }, 32);
    for (int i = 0; i < kFurnaceColumns * kFurnaceRows; ++i) {
        scene::Material material;
        material.metallic = i < kFurnaceColumns * kFurnaceRows / 2 ? 1.0f : 0.0f;
        material.roughness = kFurnaceRoughness[size_t(i) % kFurnaceRoughness.size()];
        scene.materials.push_back(material);
        const glm::vec3 at(float(i % kFurnaceColumns - kFurnaceColumns / 2),
                           float(i / kFurnaceColumns) - 0.5f * (kFurnaceRows - 1), 0);
        scene.instances.push_back({"sphere", 0, uint32_t(i), glm::translate(glm::mat4(1), at)});
    }
    return scene;
}

TEST_F(AmbientLight, WhiteSpheresOfEveryRoughnessReflectAllLight) {
    const scene::Scene scene = white_spheres();
    ASSERT_FALSE(scene.instances.empty());
    scene::Camera camera;
    camera.transform = glm::translate(glm::mat4(1), glm::vec3(0, 0, 20));
    camera.fov_y_rad = 0.33f;
    for (const char* graph : {"deferred", "forward"}) {
        const Rendered r = render(scene, camera, {280, 240, 1}, 0, {"hdr", "depth"}, graph_path(graph));
        ASSERT_EQ(r.images.size(), 2u);
        size_t surfaces = 0;
        float least = 1, most = 1;
        for (size_t i = 0; i < r.images.at("hdr").size(); ++i) {
            if (r.images.at("depth")[i].r <= 0) continue;
            ++surfaces;
            const glm::vec4 texel = r.images.at("hdr")[i];
            least = std::min({least, texel.r, texel.g, texel.b});
            most = std::max({most, texel.r, texel.g, texel.b});
        }
        std::printf("%s: %zu pixels of white spheres, %.4f to %.4f\n", graph, surfaces, double(least),
                    double(most));
        EXPECT_GT(surfaces, 500u * kFurnaceColumns * kFurnaceRows);
        EXPECT_GE(least, 0.995f);
        EXPECT_LE(most, 1.005f);
    }
}

}  // namespace
}  // namespace weft::test

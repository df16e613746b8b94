// Tests the shadow maps of the directional lights 2 to 4. The shadow of a light is compared with the shadow
// that the same light has as the first directional light, whose maps have tests of their own.
#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/session_fixture.h"
#include "tests/render/shading/quad_scene.h"

namespace weft::test {
namespace {

constexpr Extent3D kSize{320, 180, 1};

scene::Light sun_from(const glm::vec3& to_sun) {
    scene::Light light;
    light.type = scene::LightType::directional;
    light.direction = -glm::normalize(to_sun);
    light.intensity = 3;
    return light;
}

// A matt ground with a square of 1 m at a height of 1 m, under a black sky.
scene::Scene square_over_the_ground() {
    scene::Scene scene;
    scene.meshes.push_back(ground_mesh());
    scene::Material material;
    material.base_color = glm::vec4(0.8f, 0.8f, 0.8f, 1);
    material.specular = 0;
    scene.materials.push_back(material);
    const glm::mat4 above = glm::translate(glm::mat4(1), glm::vec3(0, 1, 0));
    scene.instances = {{"ground", 0, 0, glm::mat4(1)},
                       {"square", 0, 0, glm::scale(above, glm::vec3(0.125f))}};
    return scene;
}

scene::Camera camera_above() {
    scene::Camera camera;
    camera.transform = glm::inverse(glm::lookAt(glm::vec3(2, 5, 5), glm::vec3(0, 0, 0), glm::vec3(0, 1, 0)));
    camera.fov_y_rad = 0.8f;
    return camera;
}

class FurtherSuns : public SessionTest, public testing::WithParamInterface<const char*> {
 protected:
    std::vector<glm::vec4> lit_by(const std::vector<scene::Light>& lights) {
        scene::Scene scene = square_over_the_ground();
        scene.lights = lights;
        const Rendered picture = render(scene, camera_above(), kSize, 0, {"hdr"}, graph_path(GetParam()));
        return picture.images.empty() ? std::vector<glm::vec4>{} : picture.images.at("hdr");
    }
};

TEST_P(FurtherSuns, HaveTheShadowsOfTheFirst) {
    // This graph has the shader of "forward".
    if (std::string_view(GetParam()) == "light_indexed" && std::getenv("WEFT_EXTENDED") == nullptr)
        GTEST_SKIP() << "only with WEFT_EXTENDED";
    const std::vector<scene::Light> suns{sun_from({0, 1, 0.2f}), sun_from({1, 1.2f, 0.3f}),
                                         sun_from({-1, 1, 0.5f}), sun_from({0.3f, 1, -1})};
    std::vector<glm::vec4> sum(size_t{kSize.width} * kSize.height);
    std::vector<float> darkest(sum.size(), 100);
    for (const scene::Light& sun : suns) {
        const std::vector<glm::vec4> alone = lit_by({sun});
        ASSERT_EQ(alone.size(), sum.size());
        for (size_t i = 0; i < sum.size(); ++i) {
            sum[i] += alone[i];
            darkest[i] = std::min(darkest[i], alone[i].r);
        }
    }
    const std::vector<glm::vec4> together = lit_by(suns);
    ASSERT_EQ(together.size(), sum.size());
    size_t shaded = 0, different = 0;
    for (size_t i = 0; i < sum.size(); ++i) {
        shaded += sum[i].r > 0 && darkest[i] < 1e-3f ? 1 : 0;
        different += std::abs(together[i].r - sum[i].r) > 0.05f * sum[i].r + 1e-3f ? 1 : 0;
    }
    EXPECT_GT(shaded, 1000u) << "pixels in the shadow of a sun";
    // At the edges of shadows, the maps differ in the size of their texels. Each sun has a quarter of the
    // shaded pixels, so the limit is exceeded if the shadow of one sun is missing.
    EXPECT_LT(different, shaded / 5);
    std::printf("%zu of %zu pixels are in the shadow of a sun, %zu differ\n", shaded, sum.size(), different);
}

INSTANTIATE_TEST_SUITE_P(Graphs, FurtherSuns, testing::Values("deferred", "forward", "light_indexed"),
                         [](const auto& graph) { return std::string(graph.param); });

}  // namespace
}  // namespace weft::test

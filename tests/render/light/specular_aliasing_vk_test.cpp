// Tests that the highlight of a small metal sphere keeps its light, wherever its centre lies inside of a
// pixel. The highlight is smaller than a pixel. Without specular anti-aliasing, its light depends on whether
// the centre of a pixel hits it.
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "scene/procedural/procedural_mesh.h"
#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kBallSize{64, 64, 1};
constexpr float kRadius_px = 24, kDistance_m = 1000, kIlluminance_lx = 10;
constexpr double kPixel_m = 1 / double{kRadius_px};  // The sphere has a radius of 1 m.

class SpecularAliasing : public SessionTest, public testing::WithParamInterface<const char*> {
 protected:
    static scene::Scene ball(float roughness) {
        scene::MeshBuilder mesh;
        mesh.add_sphere({0, 0, 0}, 1, 192, 96);
        scene::Scene scene;
        scene.meshes.push_back(mesh.finish("ball"));
        scene::Material metal;
        metal.base_color = glm::vec4(1);
        metal.metallic = 1;
        metal.roughness = roughness;
        scene.materials.push_back(metal);
        scene.instances.push_back({});
        scene::Light light;
        light.type = scene::LightType::directional;
        light.direction = {0, 0, -1};
        light.intensity = kIlluminance_lx;
        scene.lights.push_back(light);
        return scene;
    }
    // A camera that shows the sphere at this distance from the middle of the picture, in pixels.
    static scene::Camera camera(glm::vec2 away_px) {
        const glm::vec3 aside = glm::vec3(away_px * float(kPixel_m), 0);
        scene::Camera camera;
        camera.transform = glm::translate(glm::mat4(1), glm::vec3(0, 0, kDistance_m) + aside);
        camera.fov_y_rad = 2 * std::atan(0.5f * kBallSize.height * float(kPixel_m) / kDistance_m);
        return camera;
    }
};

// A mirror in the form of a sphere scatters light evenly into all directions: the light that it sends to the
// eye is illuminance · radius² / 4.
TEST_P(SpecularAliasing, TheLightOfAHighlightDoesNotDependOnItsPlaceInThePixel) {
    const std::unique_ptr<render::Session> session =
        start(ball(0.1f), camera({0, 0}), graph_path(GetParam()), kBallSize, {"hdr"});
    ASSERT_TRUE(session);
    std::mt19937 random(20261128);
    std::uniform_real_distribution<float> in_pixel(0, 1);
    std::vector<double> sums;
    for (int i = 0; i < 16; ++i) {
        const float x = in_pixel(random), y = in_pixel(random);
        frame_of(*session).camera = camera({x, y});
        ASSERT_TRUE(draw_frame(*session) && session->finish());
        for (const vk::ReadbackData& data : session->take_readbacks()) {
            double sum = 0;
            for (const glm::vec4& texel : render::decode_texels(data.format, data.bytes)) sum += texel.g;
            sums.push_back(sum * kPixel_m * kPixel_m / session->pre_exposure() / (kIlluminance_lx / 4));
        }
    }
    ASSERT_EQ(sums.size(), 16u);
    const auto [least, most] = std::ranges::minmax(sums);
    double mean = 0;
    for (const double sum : sums) mean += sum / double(sums.size());
    std::printf("the light of the highlight: mean %.3f, from %.3f to %.3f of the closed form\n", mean, least,
                most);
    EXPECT_NEAR(mean, 1, 0.1);
    EXPECT_GE(least, 0.6);
    EXPECT_LE(most, 1.7);
}

INSTANTIATE_TEST_SUITE_P(Graphs, SpecularAliasing, testing::Values("deferred", "forward"),
                         [](const auto& graph) { return std::string(graph.param); });

}  // namespace
}  // namespace weft::test

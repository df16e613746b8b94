// Tests light from an environment map. The background is compared with a second implementation of the
// sampler. The light that simple surfaces reflect is compared with closed forms.
#include <algorithm>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/packing.hpp>

#include "tests/render/session_fixture.h"
#include "tests/render/shading/quad_scene.h"

namespace weft::test {
namespace {

constexpr Extent3D kEnvironmentSize{160, 90, 1};

scene::Environment environment_of(uint32_t width, uint32_t height,
                                  const std::function<glm::vec3(uint32_t, uint32_t)>& radiance) {
    std::vector<glm::vec3> texels;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) texels.push_back(radiance(x, y));
    return scene::build_environment(width, height, texels);
}

// Returns a scene with a horizontal square of 8 m at y = 0 that reflects only diffusely.
scene::Scene matt_plane(float albedo) {
    scene::Scene scene;
    scene.meshes.push_back(ground_mesh());
    scene::Material material;
    material.base_color = glm::vec4(glm::vec3(albedo), 1);
    material.metallic = 0;
    material.specular = 0;
    scene.materials.push_back(material);
    scene.instances.push_back({"plane", 0, 0, glm::mat4(1)});
    return scene;
}

scene::Camera camera_at(glm::vec3 eye, glm::vec3 at, float fov_y_rad) {
    scene::Camera camera;
    camera.transform = glm::inverse(glm::lookAt(eye, at, glm::vec3(0, 1, 0)));
    camera.fov_y_rad = fov_y_rad;
    return camera;
}

// Samples the environment map in direction w, independently of the shaders: bilinear interpolation of the
// four nearest texels, which wraps around horizontally and is clamped at the poles.
glm::dvec3 sampled(const scene::Environment& e, glm::dvec3 w) {
    const double u = 0.5 + std::atan2(w.x, -w.z) / (2 * std::numbers::pi),
                 v = std::acos(w.y / glm::length(w)) / std::numbers::pi;
    const double x = u * e.width_px - 0.5, y = v * e.height_px - 0.5;
    const auto texel = [&](double column, double row) {
        const auto width = static_cast<int64_t>(e.width_px);
        const auto i = static_cast<size_t>((static_cast<int64_t>(column) + width) % width);
        const auto j = static_cast<size_t>(std::clamp(row, 0.0, double(e.height_px) - 1));
        return glm::dvec3(glm::unpackF3x9_E1x5(e.mips[0][j * e.width_px + i])) * double(e.scale);
    };
    const double column = std::floor(x), row = std::floor(y), a = x - column, b = y - row;
    return (texel(column, row) * (1 - a) + texel(column + 1, row) * a) * (1 - b) +
           (texel(column, row + 1) * (1 - a) + texel(column + 1, row + 1) * a) * b;
}

class EnvironmentLight : public SessionTest {
 protected:
    void expect_background(glm::vec3 at);
};

// Renders the background in direction `at` and compares every pixel with sampled(). A texel of the map covers
// many pixels, so errors of the interpolation are visible. The tolerance depends on the difference between
// neighbouring texels, because GPU samplers place a sample with a precision of only 1/256 texel.
void EnvironmentLight::expect_background(glm::vec3 at) {
    scene::Scene scene = matt_plane(1);
    scene.environment = environment_of(16, 8, [](uint32_t x, uint32_t y) {
        return glm::vec3(1 + (x * 7 + y * 3) % 5, float(x), (x + y) % 2 == 0 ? 100.0f : 40.0f);
    });
    // The camera is below the plane. The plane is visible only from above, so it hides nothing.
    const glm::vec3 eye(0, -50, 0);
    const scene::Camera camera = camera_at(eye, eye + at, 0.9f);
    const Rendered r = render(scene, camera, kEnvironmentSize, 0, {"hdr"});
    ASSERT_EQ(r.images.size(), 1u);
    const glm::dmat3 axes(camera.transform);
    const double tan_y = std::tan(0.45), tan_x = tan_y * kEnvironmentSize.width / kEnvironmentSize.height;
    // Largest difference between neighbouring texels, per channel.
    const glm::dvec3 steepest(4, 15, 60);
    for (uint32_t y = 0; y < kEnvironmentSize.height; ++y)
        for (uint32_t x = 0; x < kEnvironmentSize.width; ++x) {
            const glm::dvec3 ray =
                axes * glm::dvec3(((x + 0.5) / kEnvironmentSize.width * 2 - 1) * tan_x,
                                  (1 - (y + 0.5) / kEnvironmentSize.height * 2) * tan_y, -1);
            const glm::dvec3 expected = sampled(scene.environment, ray);
            const glm::dvec3 found(r.images.at("hdr")[y * kEnvironmentSize.width + x]);
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(found[c], expected[c], steepest[c] * 2 / 256 + expected[c] / 1024)
                    << x << ", " << y;
        }
}

TEST_F(EnvironmentLight, TheBackgroundIsThePictureAhead) {
    expect_background({0, 0, -1});
}
TEST_F(EnvironmentLight, TheBackgroundClosesBehind) {
    expect_background({0.1f, 0.2f, 1});
}
TEST_F(EnvironmentLight, TheBackgroundHoldsToTheRight) {
    expect_background({1, -0.3f, 0});
}

TEST_F(EnvironmentLight, InAWhiteFurnaceAWhitePlaneVanishes) {
    scene::Scene scene = matt_plane(1);
    scene.environment = environment_of(32, 16, [](uint32_t, uint32_t) { return glm::vec3(2, 3, 4); });
    for (const bool metal : {false, true}) {
        scene.materials[0].metallic = metal ? 1.0f : 0.0f;
        const Rendered r = render(scene, camera_at({1, 4, 3}, {0, 0, 0}, 0.9f), kEnvironmentSize, 0,
                                  {"hdr", "depth", "albedo"});
        ASSERT_EQ(r.images.size(), 3u);
        for (size_t i = 0; i < r.images.at("hdr").size(); ++i) {
            const glm::vec4 texel = r.images.at("hdr")[i];
            ASSERT_NEAR(texel.r, 2, 0.01) << i;
            ASSERT_NEAR(texel.g, 3, 0.015) << i;
            ASSERT_NEAR(texel.b, 4, 0.02) << i;
        }
    }
}

TEST_F(EnvironmentLight, AMattPlaneSendsBackItsShareOfALinearSky) {
    scene::Scene scene = matt_plane(0.5f);
    scene.environment = environment_of(512, 256, [](uint32_t, uint32_t y) {
        return glm::vec3(float(1 + 0.5 * std::cos((y + 0.5) / 256 * std::numbers::pi)));
    });
    const Rendered r =
        render(scene, camera_at({0, 3, 0.1f}, {0, 0, 0}, 0.9f), kEnvironmentSize, 0, {"hdr", "albedo"});
    ASSERT_EQ(r.images.size(), 2u);
    const double root = r.images.at("albedo")[kEnvironmentSize.width * 45 + 80].r;
    const double found = r.images.at("hdr")[kEnvironmentSize.width * 45 + 80].r;
    EXPECT_NEAR(found, root * root * (1 + 0.5 * 2 / 3), 1e-3);
}

}  // namespace
}  // namespace weft::test

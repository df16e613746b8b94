// Tests anisotropic metal in the shipped graphs against a reference: a square that faces the camera, in
// strips of different strength and direction, under parallel light.
#include <array>
#include <numbers>

#include "tests/render/session_fixture.h"
#include "tests/render/shading/quad_scene.h"
#include "tests/render/shading/reference_anisotropy.h"

namespace weft::test {
namespace {

constexpr size_t kStrips = 4;
const glm::vec3 kColor{0.9f, 0.6f, 0.3f};

class Anisotropy : public SessionTest, public ::testing::WithParamInterface<const char*> {
 protected:
    // Returns the radiance in the middle of each strip, in cd/m².
    std::array<glm::vec3, kStrips> strips(const scene::Scene& scene) {
        return strips(scene, WEFT_SOURCE_DIR "/graphs/" + std::string(GetParam()) + ".json");
    }
    std::array<glm::vec3, kStrips> strips(const scene::Scene& scene, const std::string& path) {
        std::array<glm::vec3, kStrips> found{};
        const Rendered picture =
            render(scene, scene.cameras[0], kQuadSize, 0, {"hdr"}, path, kSingleReflections);
        if (picture.images.empty()) return found;
        for (size_t i = 0; i < kStrips; ++i) found[i] = picture.images.at("hdr")[pixel_of(i)];
        return found;
    }
    static scene::Scene striped_metal() {
        scene::Scene scene = quad_scene();
        scene.materials[0].base_color = glm::vec4(kColor, 1);
        scene.materials[0].metallic = 1;
        scene.materials[0].specular = 1;
        scene.materials[0].roughness = 0.5f;
        scene.materials.resize(kStrips, scene.materials[0]);
        scene.instances.clear();
        for (uint32_t i = 0; i < kStrips; ++i) {
            const float n = kStrips, x = (2 * static_cast<float>(i) + 1) / n - 1;
            const glm::mat4 moved = glm::translate(glm::mat4(1), glm::vec3(x, 0, 0));
            scene.instances.push_back({"strip", 0, i, glm::scale(moved, glm::vec3(1 / n, 1, 1))});
        }
        return scene;
    }
    static size_t pixel_of(size_t strip) {
        return 8 * kQuadSize.width + (2 * strip + 1) * kQuadSize.width / (2 * kStrips);
    }
    static void expect_metal(const glm::vec3& found, size_t strip, const Stretched& s, double turn_rad,
                             const glm::dvec3& from, double slack = 2e-3) {
        const auto turned = [&](const glm::dvec3& w) {
            return glm::dvec3(std::cos(turn_rad) * w.x + std::sin(turn_rad) * w.y,
                              -std::sin(turn_rad) * w.x + std::cos(turn_rad) * w.y, w.z);
        };
        // The view direction is computed for the camera's real distance of 1 km. For an infinite distance,
        // the highlights would differ measurably.
        const glm::dvec2 uv = uv_of_pixel(pixel_of(strip));
        const glm::dvec3 v = glm::normalize(glm::dvec3(1 - 2 * uv.x, 2 * uv.y - 1, 1000));
        const glm::dvec3 wanted = reflected_by_metal(s, kColor, turned(v), turned(from)) * 10.0;
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c], wanted[c], wanted[c] * slack + 1e-4) << strip << "." << c;
    }
};

// These tests depend only on materials, so they run with fewer graphs: the method of finding lights does not
// matter.
class AnisotropicMaterials : public Anisotropy {};

std::string graph_name(const ::testing::TestParamInfo<const char*>& tested) {
    return tested.param;
}
INSTANTIATE_TEST_SUITE_P(Graphs, Anisotropy,
                         ::testing::Values("deferred", "forward", "forward_plus", "light_indexed"),
                         graph_name);
INSTANTIATE_TEST_SUITE_P(Graphs, AnisotropicMaterials, ::testing::Values("deferred", "forward_plus"),
                         graph_name);

constexpr std::array<glm::dvec3, 3> kFrom{{{0.6, 0, 0.8}, {0, 0.6, 0.8}, {-0.48, 0.36, 0.8}}};

TEST_P(Anisotropy, StrengthAndRotationAreThoseOfTheExtension) {
    // This graph has the shader of "light_indexed".
    if (std::string_view(GetParam()) == "forward_plus" && std::getenv("WEFT_EXTENDED") == nullptr)
        GTEST_SKIP() << "only with WEFT_EXTENDED";
    scene::Scene scene = striped_metal();
    constexpr std::array<float, kStrips> kStrength{1.0f, 0.5f, 0.8f, 0.8f}, kTurn{0, 0, 0.7f, -2.0f};
    for (size_t i = 0; i < kStrips; ++i) {
        scene.materials[i].anisotropy = kStrength[i];
        scene.materials[i].anisotropy_rotation_rad = kTurn[i];
    }
    for (const glm::dvec3& from : kFrom) {
        scene.lights = {frontal_light(10)};
        scene.lights[0].direction = -from;
        const std::array<glm::vec3, kStrips> found = strips(scene);
        for (size_t i = 0; i < kStrips; ++i)
            expect_metal(found[i], i, stretched(0.5, kStrength[i]), kTurn[i], from);
    }
}

TEST_P(AnisotropicMaterials, TexturesTurnAndWeaken) {
    scene::Scene scene = striped_metal();
    // Each strip has a texture of one texel. The four texels encode: direction -x at full strength; +y at
    // strength 0.4; the diagonal +x+y at full strength (this material adds a quarter turn); -y at full
    // strength. Each strength is multiplied by the strength of the material, 0.8.
    const std::array<std::array<uint8_t, 4>, kStrips> texels{
        {{0, 128, 255, 255}, {128, 255, 102, 255}, {255, 255, 255, 255}, {128, 0, 255, 255}}};
    const std::array<double, kStrips> turn{0, kPi / 2, kPi / 4 + kPi / 2, -kPi / 2},
        strength{0.8, 0.32, 0.8, 0.8};
    for (uint32_t i = 0; i < kStrips; ++i) {
        scene.textures.push_back(
            {"grain", 1, 1, scene::ColorSpace::linear, {{texels[i].begin(), texels[i].end()}}});
        scene.materials[i].anisotropy = 0.8f;
        scene.materials[i].anisotropy_texture.texture = i;
        scene.materials[i].anisotropy_rotation_rad = i == 2 ? std::numbers::pi_v<float> / 2 : 0.0f;
    }
    scene.lights = {frontal_light(10)};
    scene.lights[0].direction = -kFrom[2];
    const std::array<glm::vec3, kStrips> found = strips(scene);
    // The tolerance is larger here, because a texel of 128/255 is not exactly one half.
    for (size_t i = 0; i < kStrips; ++i)
        expect_metal(found[i], i, stretched(0.5, strength[i]), turn[i], kFrom[2], 2e-2);
}

TEST_P(AnisotropicMaterials, GraphsWithoutThatDrawListShowIsotropicMetal) {
    scene::Scene scene = striped_metal();
    scene.lights = {frontal_light(10)};
    scene.lights[0].direction = -kFrom[0];
    const std::array<glm::vec3, kStrips> isotropic = strips(scene);
    for (scene::Material& material : scene.materials) material.anisotropy = 0.9f;
    EXPECT_NE(strips(scene), isotropic);
    const std::string path = testing::TempDir() + "without_grain.json";
    std::ofstream(path) << R"({"version": 1, "include": [")" << GetParam()
                        << R"(.json"], "passes": {"grain": {"if": 0}}})";
    EXPECT_EQ(strips(scene, path), isotropic);
}

TEST_P(AnisotropicMaterials, HolesOfMaskedMetalStayHoles) {
    scene::Scene scene = striped_metal();
    scene.lights = {frontal_light(10)};
    for (size_t i = 0; i < kStrips; ++i) {
        scene.materials[i].anisotropy = 0.9f;
        scene.materials[i].alpha_mode = scene::AlphaMode::mask;
        scene.materials[i].base_color.a = i % 2 == 0 ? 0.25f : 0.75f;
    }
    const std::array<glm::vec3, kStrips> found = strips(scene);
    for (size_t i = 0; i < kStrips; ++i) EXPECT_EQ(found[i].r > 0, i % 2 == 1) << i;
}

}  // namespace
}  // namespace weft::test

// Tests surfaces that let scattered light pass (KHR_materials_diffuse_transmission), surfaces with a rough
// diffuse reflection (Oren and Nayar 1994), and hair, whose tips are transparent. The references are closed
// forms, and pictures of surfaces that reflect the same light.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/render/session_fixture.h"
#include "tests/render/shading/ambient_fixture.h"
#include "tests/render/shading/quad_scene.h"

namespace weft::test {
namespace {

const glm::vec3 kScatteredColor{0.9f, 0.6f, 0.3f};
constexpr float kScatteredShare = 0.7f;
const render::ParameterValues kFixedExposure{{"autoExposure", 0}};

// Returns the share of diffuse light that crosses a slab: the mean of exp(−depth / cos θ) over all
// directions, each with the weight cos θ.
double crossing_share(double depth) {
    constexpr int kSteps = 100000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double cosine = (i + 0.5) / kSteps;
        sum += 2 * cosine * std::exp(-depth / cosine) / kSteps;
    }
    return sum;
}

scene::Light lamp_at(scene::LightType type, const glm::vec3& position) {
    scene::Light light;
    light.type = type;
    light.position = position;
    light.direction = glm::normalize(-position);
    light.side = {1, 0, 0};
    light.half_size_m = {0.6f, 0.2f};
    light.intensity = 5;
    light.color = {1, 0.8f, 0.6f};
    if (type == scene::LightType::capsule) light.direction = {0, 1, 0};
    return light;
}

class Scattering : public SessionTest, public ::testing::WithParamInterface<const char*> {
 protected:
    std::vector<glm::vec4> picture(const scene::Scene& scene, Extent3D size = kQuadSize) {
        const Rendered found = render(scene, scene.cameras[0], size, 0, {"hdr"}, graph(), kFixedExposure);
        return found.images.empty() ? std::vector<glm::vec4>() : found.images.at("hdr");
    }
    static std::string graph() { return WEFT_SOURCE_DIR "/graphs/" + std::string(GetParam()) + ".json"; }
    static scene::Scene slab(float thickness_m, const glm::vec3& absorption_per_m) {
        scene::Scene scene = quad_scene();
        scene::Material& material = scene.materials[0];
        material.base_color = {0.5f, 0.5f, 0.5f, 1};
        material.diffuse_transmission = kScatteredShare;
        material.diffuse_transmission_color = kScatteredColor;
        material.thickness_m = thickness_m;
        material.absorption_per_m = absorption_per_m;
        return scene;
    }
};

TEST_P(Scattering, ASlabLetsTheLightOfTheClosedFormPass) {
    constexpr float kIlluminance = 100;
    for (const float thickness_m : {0.0f, 0.02f, 0.1f, 0.5f}) {
        const glm::vec3 absorption{2, 8, 0.5f};
        scene::Scene scene = slab(thickness_m, absorption);
        scene.lights = {frontal_light(kIlluminance)};
        scene.lights[0].direction = {0, 0, 1};
        const std::vector<glm::vec4> found = picture(scene);
        ASSERT_FALSE(found.empty());
        for (int c = 0; c < 3; ++c) {
            const double wanted = kScatteredShare * double{kScatteredColor[c]} * kIlluminance *
                                  crossing_share(double{absorption[c]} * double{thickness_m}) /
                                  std::numbers::pi;
            EXPECT_NEAR(found[8 * kQuadSize.width + 8][c], wanted, wanted * 0.01)
                << thickness_m << " m, channel " << c;
        }
    }
}

// Light from behind looks like the same light from the front on a surface that reflects as much.
TEST_P(Scattering, AllLightsPass) {
    using Type = scene::LightType;
    for (const Type type : {Type::point, Type::spot, Type::capsule, Type::rectangle, Type::directional}) {
        scene::Scene behind = slab(0.05f, {3, 5, 9});
        behind.lights = {lamp_at(type, {0.3f, 0.4f, -1.25f})};
        scene::Scene front = quad_scene();
        for (int c = 0; c < 3; ++c)
            front.materials[0].base_color[c] =
                float(kScatteredShare * double{kScatteredColor[c]} *
                      crossing_share(double{behind.materials[0].absorption_per_m[c]} * 0.05));
        // The light enters at the back of the slab, 0.05 m behind the front.
        front.lights = {lamp_at(type, {0.3f, 0.4f, 1.2f})};
        front.lights[0].direction = behind.lights[0].direction * glm::vec3(1, 1, -1);
        const std::vector<glm::vec4> found = picture(behind), wanted = picture(front);
        ASSERT_FALSE(found.empty() || wanted.empty());
        double most = 0;
        for (size_t i = 0; i < found.size(); ++i)
            for (int c = 0; c < 3; ++c)
                most = std::max(most, std::abs(double{found[i][c]} - double{wanted[i][c]}) /
                                          std::max(double{wanted[i][c]}, 1e-3));
        std::printf("light %d: largest difference %.4f\n", int(type), most);
        EXPECT_LE(most, 0.01);
    }
}

// A white surface in uniform light reflects and transmits all light, so it cannot be seen.
TEST_P(Scattering, NeitherAddsNorLosesLight) {
    for (const float tilt_rad : {0.0f, 1.2f})
        for (const float share : {0.0f, 0.4f, 1.0f}) {
            scene::Scene scene = quad_scene();
            scene.materials[0].specular = 1;
            scene.materials[0].roughness = 0.4f;
            scene.instances[0].transform = glm::rotate(glm::mat4(1), tilt_rad, glm::vec3(0, 1, 0));
            scene.environment = picture_of([](const glm::dvec3&) { return 1; }, 32);
            scene.materials[0].diffuse_transmission = share;
            const std::vector<glm::vec4> found = picture(scene);
            ASSERT_FALSE(found.empty());
            // Behind and beside the surface, the picture shows the same light.
            for (const glm::vec4& light : found) EXPECT_NEAR(light.g, 1, 0.012) << share << ", " << tilt_rad;
        }
}

// The light and the eye are in the same direction, 60° from the normal. Source of the value: the formula of
// the qualitative model with σ = 0.5.
TEST_P(Scattering, ARoughDiffuseSurfaceReflectsLightBack) {
    constexpr double kFactor = 1.2808, kAlbedo = 0.5, kIlluminance = 100;
    scene::Scene scene = quad_scene();
    scene.materials[0].base_color = {0.5f, 0.5f, 0.5f, 1};
    scene.instances[0].transform = glm::rotate(glm::mat4(1), glm::radians(60.0f), glm::vec3(0, 1, 0));
    scene.lights = {frontal_light(float(kIlluminance))};
    for (const double sigma : {0.0, 0.5}) {
        scene.materials[0].diffuse_roughness_rad = float(sigma);
        const std::vector<glm::vec4> found = picture(scene);
        ASSERT_FALSE(found.empty());
        const double wanted = kAlbedo / std::numbers::pi * kIlluminance * 0.5 * (sigma > 0 ? kFactor : 1.0);
        EXPECT_NEAR(found[8 * kQuadSize.width + 8].g, wanted, wanted * 0.005) << sigma;
    }
}

// The left half is an opaque, masked part of a strand of hair. The right half is its tip, which is blended.
TEST_P(Scattering, TheTipOfAHairHasNoSeam) {
    scene::Scene scene = quad_scene();
    scene.sky_zenith = {0.4f, 0.5f, 0.7f};
    scene.sky_horizon = {0.6f, 0.6f, 0.5f};
    scene::Material& strand = scene.materials[0];
    strand.base_color = {0.3f, 0.2f, 0.1f, 1};
    strand.roughness = 0.45f;
    strand.specular = 1;
    strand.anisotropy = 0.8f;
    strand.anisotropy_rotation_rad = 0.7f;
    strand.alpha_mode = scene::AlphaMode::mask;
    scene::Material tip = strand;
    tip.alpha_mode = scene::AlphaMode::blend;
    tip.base_color.a = 0.999f;
    scene.materials.push_back(tip);
    scene.instances.clear();
    for (uint32_t i = 0; i < 2; ++i) {
        const glm::mat4 moved = glm::translate(glm::mat4(1), glm::vec3(i == 0 ? -0.5f : 0.5f, 0, 0));
        scene.instances.push_back({"half", 0, i, glm::scale(moved, glm::vec3(0.5f, 1, 1))});
    }
    // The lights shine from far away, so both halves get the same light.
    scene.lights = {frontal_light(3), lamp_at(scene::LightType::point, {200, 300, 500})};
    scene.lights[0].direction = glm::normalize(glm::vec3(-0.3f, -0.5f, -1));
    scene.lights[1].intensity = 8e5f;
    const std::vector<glm::vec4> found = picture(scene);
    ASSERT_FALSE(found.empty());
    const glm::vec4 left = found[8 * kQuadSize.width + 6], right = found[8 * kQuadSize.width + 9];
    std::printf("strand %.4f, tip %.4f\n", double(left.g), double(right.g));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(right[c], left[c], 0.01f * left[c]);
}

INSTANTIATE_TEST_SUITE_P(All, Scattering, ::testing::Values("deferred", "forward"),
                         [](const auto& graph) { return std::string(graph.param); });

}  // namespace
}  // namespace weft::test

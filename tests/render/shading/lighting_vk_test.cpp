// Tests the deferred picture against an independent reference in double precision: every pixel is computed
// from the saved G-buffer, and planes under one light are compared with closed forms.
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/session_fixture.h"
#include "tests/render/shading/quad_scene.h"
#include "tests/render/shading/reference_brdf.h"
#include "tests/render/shading/reference_light.h"
#include "weft/scene/builtin_scenes.h"

namespace weft::test {
namespace {

constexpr Extent3D kLightingSize{320, 180, 1};

class Lighting : public SessionTest {};

TEST_F(Lighting, EveryPixelOfTheSpheresFollowsFromTheGBuffer) {
    Result<scene::Scene> scene = scene::make_builtin("spheres");
    ASSERT_TRUE(scene);
    scene->sky_zenith = scene->sky_horizon = glm::vec3(0);
    ASSERT_EQ(scene->lights.size(), 1u);
    params_["lampShadowMaps"] = 0;  // The reference has no shadows.
    const Rendered r = render(*scene, scene->cameras.at(0), kLightingSize, scene->exposure_ev,
                              {"albedo", "normal", "orm", "specular", "depth", "hdr@gbuffer", "hdr"},
                              kDeferredGraph, kSingleReflections);
    ASSERT_EQ(r.images.size(), 7u);
    const glm::dmat4 to_world = glm::inverse(glm::dmat4(r.view.projection) * glm::dmat4(r.view.view));
    size_t surfaces = 0, wrong = 0;
    double worst = 0;
    for (size_t i = 0; i < r.images.at("hdr").size(); ++i) {
        const double z = r.images.at("depth")[i].r;
        if (z <= 0) continue;
        ++surfaces;
        const double u = (double(i % kLightingSize.width) + 0.5) / kLightingSize.width,
                     v = (double(i / kLightingSize.width) + 0.5) / kLightingSize.height;
        const glm::dvec4 world = to_world * glm::dvec4(u * 2 - 1, v * 2 - 1, z, 1);
        const glm::dvec3 at = glm::dvec3(world) / world.w;
        const glm::dvec4 orm = r.images.at("orm")[i], coat = r.images.at("specular")[i];
        ReferenceSurface s;
        s.normal = octahedral_normal(r.images.at("normal")[i]);
        const glm::dvec3 root(r.images.at("albedo")[i]);
        s.base_color = root * root;
        s.metallic = orm.b;
        s.roughness = orm.g;
        s.dielectric_f0 = glm::dvec3(coat) * glm::dvec3(coat);
        s.specular = coat.a;
        glm::dvec3 l;
        const glm::dvec3 e = incident(r.lights.at(0), at, l);
        const glm::dvec3 eye = glm::normalize(glm::dvec3(r.view.eye) - at);
        const glm::dvec3 expected =
            glm::dvec3(r.images.at("hdr@gbuffer")[i]) + reflected(s, eye, l) * e * double(r.pre_exposure);
        const glm::dvec3 found(r.images.at("hdr")[i]);
        // Two absolute errors are subtracted before the relative error is computed. The half floats of the
        // image have an error of up to 6e-8 (2⁻²⁴, the smallest positive half float). The shader computes n·l
        // in float with an error of about 3e-7; the test allows 5e-7.
        const glm::dvec3 slack = glm::dvec3(6e-8) + e * double(r.pre_exposure) * 5e-7;
        for (int c = 0; c < 3; ++c) {
            const double stored = std::min(expected[c], 65000.0);
            const double error =
                std::max(0.0, std::abs(found[c] - stored) - slack[c]) / std::max(stored, 1e-12);
            worst = std::max(worst, error);
            if (error > 1e-3) ++wrong;
        }
    }
    EXPECT_GT(surfaces, 10000u);
    EXPECT_EQ(wrong, 0u) << "worst relative error " << worst;
    std::printf("%zu surface pixels, worst relative error %.2e\n", surfaces, worst);
}

struct PlaneCase {
    const char* name;
    scene::LightType light;
    bool metal;
};

class Plane : public SessionTest, public ::testing::WithParamInterface<PlaneCase> {};

// Returns a scene with a horizontal white square of 8 m at y = 0 and one light.
scene::Scene plane_scene(const PlaneCase& c) {
    scene::Scene scene;
    scene.meshes.push_back(ground_mesh());
    scene::Material material;
    material.metallic = c.metal ? 1.0f : 0.0f;
    material.roughness = 0.4f;
    material.specular = c.metal ? 1.0f : 0.0f;
    scene.materials.push_back(material);
    scene.instances.push_back({"plane", 0, 0, glm::mat4(1)});
    scene::Light light;
    light.type = c.light;
    light.position = {0.5f, 2, -0.25f};
    light.direction = glm::normalize(glm::vec3(0.1f, -1, 0.2f));
    light.intensity = 10;
    light.inner_cone_rad = 0.3f;
    light.outer_cone_rad = 0.9f;
    scene.lights.push_back(light);
    return scene;
}

TEST_P(Plane, FollowsItsClosedForm) {
    const scene::Scene scene = plane_scene(GetParam());
    scene::Camera camera;
    camera.transform = glm::inverse(glm::lookAt(glm::vec3(1, 4, 3), glm::vec3(0, 0, 0), glm::vec3(0, 1, 0)));
    camera.fov_y_rad = 0.7f;
    const Rendered r = render(scene, camera, kLightingSize, 0, {"hdr"}, kDeferredGraph, kSingleReflections);
    ASSERT_EQ(r.images.size(), 1u);
    const glm::dvec3 eye(1, 4, 3);
    const glm::dmat3 axes(camera.transform);
    const double tan_y = std::tan(double(camera.fov_y_rad) / 2),
                 tan_x = tan_y * kLightingSize.width / kLightingSize.height;
    ReferenceSurface s;
    s.metallic = GetParam().metal ? 1 : 0;
    s.roughness = 0.4;
    s.specular = GetParam().metal ? 1 : 0;
    std::vector<double> errors;
    for (uint32_t y = 0; y < kLightingSize.height; ++y) {
        for (uint32_t x = 0; x < kLightingSize.width; ++x) {
            const glm::dvec3 ray = axes * glm::dvec3(((x + 0.5) / kLightingSize.width * 2 - 1) * tan_x,
                                                     (1 - (y + 0.5) / kLightingSize.height * 2) * tan_y, -1);
            const glm::dvec3 at = eye + ray * (-eye.y / ray.y);
            if (ray.y >= 0 || std::max(std::abs(at.x), std::abs(at.z)) > 3.95) continue;
            glm::dvec3 l;
            const glm::dvec3 e = incident(r.lights.at(0), at, l);
            const double expected = reflected(s, glm::normalize(eye - at), l).x * e.x;
            const double found = r.images.at("hdr")[size_t{y} * kLightingSize.width + x].r;
            if (expected < 1e-4) {
                EXPECT_NEAR(found, expected, 2e-6);
            } else {
                errors.push_back(std::abs(found - expected) / expected);
            }
        }
    }
    ASSERT_GT(errors.size(), 10000u);
    std::sort(errors.begin(), errors.end());
    const double p99 = errors[errors.size() * 99 / 100];
    EXPECT_LE(p99, 2e-3);
    std::printf("%zu pixels, 99th percentile of the relative error %.2e, worst %.2e\n", errors.size(), p99,
                errors.back());
}

INSTANTIATE_TEST_SUITE_P(
    Lights, Plane,
    ::testing::Values(PlaneCase{"LambertPoint", scene::LightType::point, false},
                      PlaneCase{"LambertSpot", scene::LightType::spot, false},
                      PlaneCase{"LambertDirectional", scene::LightType::directional, false},
                      PlaneCase{"MetalPoint", scene::LightType::point, true},
                      PlaneCase{"MetalSpot", scene::LightType::spot, true},
                      PlaneCase{"MetalDirectional", scene::LightType::directional, true}),
    [](const auto& c) { return c.param.name; });

}  // namespace
}  // namespace weft::test

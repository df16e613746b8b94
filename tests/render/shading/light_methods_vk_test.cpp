// Compares two methods for finding the lights of a pixel with a loop over all lights. Tiled shading in one
// pass must give exactly the same picture. Light volumes blend each light into an image of half floats (11
// significant bits). So the sum of a pixel is rounded once for each light that reaches it, to nearest or
// towards 0. No partial sum exceeds the total, so the error of a pixel has this bound:
// |blended − looped| ≤ (lights + 2) · 2⁻¹⁰ · looped + (lights + 2) · 2⁻²⁴
// The 2 is for the rounding of the initial value and of the loop's result. The smallest half floats are 2⁻²⁴
// apart, which gives the last term.
#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/session_fixture.h"
#include "tests/render/shading/reference_light.h"

namespace weft::test {
namespace {

constexpr Extent3D kLightMethodsSize{320, 180, 1};
using Image = std::vector<glm::vec4>;

// Returns the scene "lights" with two more rectangle lights, one at each of the first two cameras. These are
// the last lights in the list, so a method that drops the last light fails.
scene::Scene lights_scene(uint32_t lights) {
    Result<scene::Scene> scene = scene::make_builtin("lights", {.lights = lights});
    EXPECT_TRUE(scene);
    for (const size_t camera : {1u, 0u}) {
        const glm::mat4& at = scene->cameras.at(camera).transform;
        scene::Light light;
        light.name = "last";
        light.type = scene::LightType::rectangle;
        light.position = glm::vec3(at[3]);
        light.direction = -glm::vec3(at[2]);
        light.side = glm::vec3(at[0]);
        light.half_size_m = {0.2f, 0.2f};
        light.range_m = 12;
        light.intensity = 100;
        scene->lights.push_back(light);
    }
    return std::move(*scene);
}

// Adds lights that are special cases for light volumes: narrow and wide cones, cones that contain the eye,
// lights without a range, and a light behind the eye.
void add_awkward_lights(scene::Scene& scene, const scene::Camera& camera) {
    const glm::vec3 eye(camera.transform[3]), ahead = -glm::vec3(camera.transform[2]);
    const auto add = [&](scene::LightType type, const glm::vec3& position, float range_m, float cone_rad) {
        scene::Light light;
        light.name = "awkward";
        light.type = type;
        light.position = position;
        light.direction = glm::normalize(ahead + glm::vec3(0.1f, -0.3f, 0.05f));
        light.range_m = range_m;
        light.intensity = 3;
        light.outer_cone_rad = cone_rad;
        light.inner_cone_rad = cone_rad / 2;
        scene.lights.push_back(light);
    };
    using enum scene::LightType;
    for (const float cone_rad : {0.02f, 0.3f, 0.8f, 1.0f, 1.1f, 1.5f}) {
        add(spot, eye + 2.0f * ahead, 6, cone_rad);
        add(spot, eye - 0.3f * ahead, 6, cone_rad);
        add(spot, eye + 0.01f * ahead, 0, cone_rad);
    }
    add(point, eye + 0.2f * ahead, 9, 0);
    add(point, eye - 3.0f * ahead, 8, 0);
    add(point, eye, 0.06f, 0);
    add(point, eye + 5.0f * ahead, 0, 0);
}

class LightMethods : public SessionTest {
 protected:
    Rendered drawn(const scene::Scene& scene, const std::string& graph, const scene::Camera& camera) {
        return render(scene, camera, kLightMethodsSize, scene.exposure_ev, {"hdr@lighting", "depth"},
                      graph_path(graph));
    }
    void expect_the_same(const scene::Scene& scene, const scene::Camera& camera) {
        const Rendered looped = drawn(scene, "deferred", camera),
                       tiled = drawn(scene, "tiled_deferred", camera);
        ASSERT_TRUE(looped.images.contains("hdr@lighting") && tiled.images.contains("hdr@lighting"));
        const Image &a = looped.images.at("hdr@lighting"), &b = tiled.images.at("hdr@lighting");
        ASSERT_EQ(a.size(), size_t{kLightMethodsSize.width} * kLightMethodsSize.height);
        size_t differ = 0;
        for (size_t i = 0; i < a.size(); ++i) differ += a[i] != b[i] ? 1 : 0;
        EXPECT_EQ(differ, 0u) << "of " << a.size() << " pixels";
    }
};

glm::dvec3 position_of(const shared::ViewConstants& view, size_t pixel, float z) {
    const double x = static_cast<double>(pixel % kLightMethodsSize.width) + 0.5,
                 y = static_cast<double>(pixel / kLightMethodsSize.width) + 0.5;
    const glm::dvec4 at =
        glm::dmat4(view.inverse_view_projection) *
        glm::dvec4(2 * x / kLightMethodsSize.width - 1, 2 * y / kLightMethodsSize.height - 1, z, 1);
    return glm::dvec3(at) / at.w;
}

double reaching(const std::vector<shared::Light>& lights, const glm::dvec3& position) {
    double count = 0;
    for (const shared::Light& light : lights) {
        glm::dvec3 l;
        const glm::dvec3 sent = incident(light, position, l);
        count += sent.x + sent.y + sent.z > 0 ? 1 : 0;
    }
    return count;
}

// Returns the largest error of any channel of any pixel, divided by the bound for this pixel (the formula at
// the start of this file). A result above 1 is a failure.
double worst_share(const Rendered& looped, const Rendered& blended) {
    const Image &a = looped.images.at("hdr@lighting"), &b = blended.images.at("hdr@lighting"),
                &depth = looped.images.at("depth");
    double worst = 0, lights = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        const bool is_sky = depth[i].r <= 0;
        const double n = is_sky ? 0 : reaching(looped.lights, position_of(looped.view, i, depth[i].r)) + 2;
        lights = std::max(lights, n - 2);
        for (int c = 0; c < 3; ++c) {
            const double bound = n * (std::ldexp(1.0, -10) * a[i][c] + std::ldexp(1.0, -24));
            const double off = std::abs(double{a[i][c]} - double{b[i][c]});
            if (off > 0) worst = std::max(worst, off / std::max(bound, 1e-12));
        }
    }
    std::printf("up to %.0f lights a pixel; %.3f of the bound are taken at most\n", lights, worst);
    return worst;
}

TEST_F(LightMethods, TiledShadingIsTheLoopOverAllLights) {
    const scene::Scene scene = lights_scene(256);
    for (const size_t camera : {0u, 1u}) expect_the_same(scene, scene.cameras.at(camera));
}

TEST_F(LightMethods, TiledShadingTakesLightsOfEveryShape) {
    scene::Scene scene = lights_scene(8);
    add_awkward_lights(scene, scene.cameras.at(0));
    expect_the_same(scene, scene.cameras[0]);
}

TEST_F(LightMethods, VolumesBlendWhatTheLoopAddsUp) {
    const scene::Scene scene = lights_scene(256);
    for (const size_t camera : {0u, 1u}) {
        const Rendered looped = drawn(scene, "deferred", scene.cameras.at(camera));
        EXPECT_LE(worst_share(looped, drawn(scene, "light_volumes", scene.cameras[camera])), 1);
    }
}

TEST_F(LightMethods, VolumesTakeLightsOfEveryShape) {
    scene::Scene scene = lights_scene(8);
    add_awkward_lights(scene, scene.cameras.at(0));
    const Rendered looped = drawn(scene, "deferred", scene.cameras[0]);
    EXPECT_LE(worst_share(looped, drawn(scene, "light_volumes", scene.cameras[0])), 1);
}

TEST_F(LightMethods, NeitherMindsHavingNoneToFind) {
    Result<scene::Scene> scene = scene::make_builtin("spheres");
    ASSERT_TRUE(scene);
    std::erase_if(scene->lights,
                  [](const scene::Light& l) { return l.type != scene::LightType::directional; });
    expect_the_same(*scene, scene->cameras.at(0));
    const Rendered looped = drawn(*scene, "deferred", scene->cameras[0]);
    EXPECT_LE(worst_share(looped, drawn(*scene, "light_volumes", scene->cameras[0])), 1);
}

}  // namespace
}  // namespace weft::test

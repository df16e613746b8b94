// Tests that reflections neither lose light nor add light: uniform light stays uniform, and light between
// mirrors that face each other stays bounded.
#include <algorithm>

#include "tests/render/reflections/reflection_fixture.h"
#include "tests/render/shading/ambient_fixture.h"

namespace weft::test {
namespace {

class ReflectedEnergy : public ReflectionTest {
 protected:
    static constexpr Extent3D kEnergySize{160, 90, 1};
};

// Metals that reflect all light, and emitters, in surroundings of the same radiance: nothing can be seen.
TEST_F(ReflectedEnergy, KeepsUniformLightUniform) {
    for (const float roughness : {0.0f, 0.05f, 0.2f, 0.4f, 0.6f}) {
        scene::Scene scene;
        scene.environment = picture_of([](const glm::dvec3&) { return 1; }, 32);
        add_box(scene, {-3, -0.1f, -3}, {3, 0, 3}, metal(roughness));
        add_box(scene, {-1.1f, 0, -0.7f}, {-0.3f, 0.8f, 0}, emitter(glm::vec3(1)));
        add_box(scene, {0.1f, 0, -1.2f}, {0.8f, 1.1f, -0.6f}, metal(roughness));
        const LastFrame last = draw(scene, scene::camera_looking_at({0.3f, 1.2f, 3}, {0, 0.3f, 0}, 0.8f),
                                    kEnergySize, 16, {"hdr", "ssr.layer(0)"});
        float least = 10, most = 0, surest = 0;
        for (const glm::vec4& light : last.images.at("hdr")) {
            least = std::min(least, light.g / last.pre_exposure);
            most = std::max(most, light.g / last.pre_exposure);
        }
        for (const glm::vec4& light : last.images.at("ssr.layer(0)")) surest = std::max(surest, light.a);
        std::printf("roughness %.2f: radiance %.4f to %.4f\n", double(roughness), double(least),
                    double(most));
        EXPECT_GE(least, 0.99f);
        EXPECT_LE(most, 1.01f);
        EXPECT_GT(surest, 0.3f);
    }
}

// A lamp between three mirrors that reflect 95 % of the light: no pixel becomes brighter than the lamp.
TEST_F(ReflectedEnergy, StaysBoundedBetweenMirrors) {
    scene::Scene scene;
    add_box(scene, {-3, -0.1f, -3}, {3, 0, 3}, metal(0.1f, 0.95f));
    add_box(scene, {-3, 2, -3}, {3, 2.1f, 3}, metal(0.1f, 0.95f));
    add_box(scene, {-3, 0, -3.1f}, {3, 2, -3}, metal(0.1f, 0.95f));
    add_box(scene, {-0.3f, 0.7f, -0.3f}, {0.3f, 1.2f, 0.3f}, emitter(glm::vec3(1)));
    const scene::Camera camera = scene::camera_looking_at({0.3f, 1.2f, 2.6f}, {0, 0.9f, 0}, 0.9f);
    const auto brightest = [&](int frames) {
        const LastFrame last = draw(scene, camera, {64, 36, 1}, frames, {"hdr"});
        float most = 0;
        for (const glm::vec4& light : last.images.at("hdr"))
            most = std::max({most, light.r / last.pre_exposure, light.g / last.pre_exposure,
                             light.b / last.pre_exposure});
        return most;
    };
    const float after_100 = brightest(100), after_500 = brightest(500);
    std::printf("brightest pixel: %.3f after 100 frames, %.3f after 500\n", double(after_100),
                double(after_500));
    EXPECT_GE(after_100, 0.99f);
    EXPECT_LE(after_500, 1.02f * after_100);
    EXPECT_LE(after_500, 1.05f);
}

}  // namespace
}  // namespace weft::test

// Tests surfaces with a clear coat (KHR_materials_clearcoat): the two layers neither add nor lose light, and
// the coat mirrors the same light as a dielectric surface without anything below, also from the reflections
// of the screen.
#include <algorithm>

#include "tests/render/reflections/reflection_fixture.h"
#include "tests/render/shading/ambient_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kCoatSize{160, 90, 1};

scene::Material black(float specular, float roughness) {
    scene::Material material;
    material.base_color = {0, 0, 0, 1};
    material.metallic = 0;
    material.specular = specular;
    material.roughness = roughness;
    return material;
}

class ClearCoat : public ReflectionTest {
 protected:
    LastFrame look_at_floor(const scene::Scene& scene, const std::string& graph, int frames) {
        return draw(scene, scene::camera_looking_at({0.3f, 1.0f, 2.6f}, {0, 0.2f, 0}, 0.8f), kCoatSize,
                    frames, {"hdr"}, graph);
    }
    // Two boxes that emit light stand on a floor of this material.
    static scene::Scene boxes_on(const scene::Material& floor) {
        scene::Scene scene;
        scene.sky_zenith = scene.sky_horizon = glm::vec3(0.3f);
        add_box(scene, {-4, -0.1f, -4}, {4, 0, 4}, floor);
        add_box(scene, {-0.9f, 0, -0.6f}, {-0.3f, 0.7f, -0.1f}, emitter({2, 0.4f, 0.2f}));
        add_box(scene, {0.3f, 0, -1}, {0.8f, 1, -0.6f}, emitter({0.3f, 1, 2}));
        return scene;
    }
};

TEST_F(ClearCoat, NeitherAddsNorLosesLight) {
    for (const char* graph : {"deferred", "forward"}) {
        for (const float coat : {0.5f, 1.0f}) {
            scene::Scene scene;
            scene.environment = picture_of([](const glm::dvec3&) { return 1; }, 32);
            scene::Material material = metal(0.3f);
            material.clearcoat = coat;
            material.clearcoat_roughness = 0.1f;
            add_box(scene, {-3, -0.1f, -3}, {3, 0, 3}, material);
            const LastFrame last = look_at_floor(scene, graph_path(graph), 1);
            float least = 10, most = 0;
            for (const glm::vec4& light : last.images.at("hdr")) {
                least = std::min(least, light.g / last.pre_exposure);
                most = std::max(most, light.g / last.pre_exposure);
            }
            std::printf("%s, coat %.1f: radiance %.4f to %.4f\n", graph, double(coat), double(least),
                        double(most));
            EXPECT_GE(least, 0.99f);
            EXPECT_LE(most, 1.01f);
        }
    }
}

TEST_F(ClearCoat, MirrorsLikeADielectricSurface) {
    scene::Material coated = black(0, 1);
    coated.clearcoat = 1;
    const LastFrame coat = look_at_floor(boxes_on(coated), kReflectionGraph, 4);
    const LastFrame plain = look_at_floor(boxes_on(black(1, 0)), kReflectionGraph, 4);
    const LastFrame rough = look_at_floor(boxes_on(black(0, 1)), kReflectionGraph, 4);
    const auto difference = [&](const LastFrame& a, const LastFrame& b) {
        float most = 0;
        for (size_t i = 0; i < a.images.at("hdr").size(); ++i)
            most =
                std::max(most, std::abs(a.images.at("hdr")[i].g - b.images.at("hdr")[i].g) / a.pre_exposure);
        return most;
    };
    std::printf("largest difference: %.5f to a dielectric surface, %.3f to a surface without coat\n",
                double(difference(coat, plain)), double(difference(coat, rough)));
    EXPECT_LE(difference(coat, plain), 0.003f);
    EXPECT_GE(difference(coat, rough), 0.05f);
}

}  // namespace
}  // namespace weft::test

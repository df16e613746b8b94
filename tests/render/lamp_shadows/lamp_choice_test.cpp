// Tests which lamps get shadow maps, and the views of the maps. No device is needed.
#include <gtest/gtest.h>

#include "render/frame_data.h"
#include "render/views/lamp_shadows.h"
#include "shared/lamp_shadow.glsl"

namespace weft::test {
namespace {

scene::Light lamp_at(scene::LightType type, float x, float intensity = 1) {
    scene::Light light;
    light.type = type;
    light.position = {x, 0, 0};
    light.range_m = 1;
    light.intensity = intensity;
    light.half_size_m = {0.1f, 0.1f};
    light.outer_cone_rad = 0.5f;
    return light;
}

// A camera at x that looks along −z.
shared::ViewConstants camera_at(float x, float z) {
    scene::Camera camera;
    camera.transform[3] = {x, 0, z, 1};
    return render::view_constants(camera, glm::mat4(1), 160, 90);
}

std::vector<uint32_t> shadows_of(const render::LampShadows& shadows) {
    std::vector<uint32_t> numbers;
    for (const shared::Light& light : shadows.lights()) numbers.push_back(light.shadow);
    return numbers;
}

constexpr uint32_t kFirst = shared::kFirstLampMap;

TEST(LampChoice, CountsMaps) {
    const auto count = [](scene::LightType type, float cone = 0.5f) {
        scene::Light light = lamp_at(type, 0);
        light.outer_cone_rad = cone;
        return render::count_lamp_maps(render::gpu_light(light));
    };
    EXPECT_EQ(count(scene::LightType::directional), 0u);
    EXPECT_EQ(count(scene::LightType::spot), 1u);
    EXPECT_EQ(count(scene::LightType::spot, 1.2f), 6u) << "too wide for one map";
    EXPECT_EQ(count(scene::LightType::point), 6u);
    EXPECT_EQ(count(scene::LightType::capsule), 6u);
    EXPECT_EQ(count(scene::LightType::rectangle), 6u);
}

TEST(LampChoice, TakesTheLampsWithTheLargestInfluence) {
    const std::vector<shared::Light> lights = render::gpu_lights(
        std::vector{lamp_at(scene::LightType::spot, 0, 1), lamp_at(scene::LightType::spot, 0.1f, 3),
                    lamp_at(scene::LightType::point, 0, 2), lamp_at(scene::LightType::spot, 90, 50)},
        0);
    render::LampShadows shadows;
    shadows.update(lights, camera_at(0, 3), 2);
    EXPECT_EQ(shadows_of(shadows), (std::vector<uint32_t>{kFirst + 1, kFirst, 0, 0}))
        << "a point has no room";
    shadows.update(lights, camera_at(0, 3), 7);
    EXPECT_NE(shadows_of(shadows)[1], 0u);
    EXPECT_NE(shadows_of(shadows)[2], 0u);
    shadows.update(lights, camera_at(0, 3), 0);
    EXPECT_EQ(shadows_of(shadows), (std::vector<uint32_t>{0, 0, 0, 0}));
    EXPECT_TRUE(shadows.views().empty());
}

TEST(LampChoice, KeepsMapsOfLampsThatStay) {
    std::vector<shared::Light> lights = render::gpu_lights(
        std::vector{lamp_at(scene::LightType::spot, 0, 1), lamp_at(scene::LightType::spot, 0.1f, 1.1f)}, 0);
    render::LampShadows shadows;
    shadows.update(lights, camera_at(0, 3), 1);
    EXPECT_EQ(shadows_of(shadows), (std::vector<uint32_t>{0, kFirst}));
    lights[0].intensity *= 1.2f;  // A little more than the other, but not enough to take its map.
    shadows.update(lights, camera_at(0, 3), 1);
    EXPECT_EQ(shadows_of(shadows), (std::vector<uint32_t>{0, kFirst}));
    lights[0].intensity *= 2;
    shadows.update(lights, camera_at(0, 3), 1);
    EXPECT_EQ(shadows_of(shadows), (std::vector<uint32_t>{kFirst, 0}));
}

TEST(LampChoice, ClosesGapsIfALampHasNoRoom) {
    std::vector<shared::Light> lights = render::gpu_lights(
        std::vector{lamp_at(scene::LightType::spot, 0, 3), lamp_at(scene::LightType::spot, 0, 2),
                    lamp_at(scene::LightType::spot, 0, 1), lamp_at(scene::LightType::point, 0, 0.5f)},
        0);
    render::LampShadows shadows;
    shadows.update(lights, camera_at(0, 3), 7);
    EXPECT_EQ(shadows_of(shadows), (std::vector<uint32_t>{kFirst, kFirst + 1, kFirst + 2, 0}));
    // Only the second spot keeps its map, and the free maps on both sides of it are too few for a point
    // light.
    lights[0].intensity *= 0.01f;
    lights[1].intensity *= 2;
    lights[3].intensity *= 20;
    shadows.update(lights, camera_at(0, 3), 7);
    EXPECT_EQ(shadows_of(shadows), (std::vector<uint32_t>{0, kFirst + 6, 0, kFirst}));
}

// The order of the buffer: plain lights without maps, plain lights with maps, all others. Within each of
// these groups, the order stays the same.
TEST(LampChoice, PlainLampsWithMapsFollowAfterThoseWithout) {
    const std::vector<shared::Light> lights = render::gpu_lights(
        std::vector{lamp_at(scene::LightType::directional, 0), lamp_at(scene::LightType::spot, 0, 9),
                    lamp_at(scene::LightType::spot, 1, 1), lamp_at(scene::LightType::spot, 2, 8),
                    lamp_at(scene::LightType::spot, 3, 2), lamp_at(scene::LightType::rectangle, 4, 3)},
        0);
    render::LampShadows shadows;
    shadows.update(lights, camera_at(0, 3), 10);
    EXPECT_EQ(shadows.count_unshadowed(), 1u) << "10 maps are enough for all lamps";
    shadows.update(lights, camera_at(0, 3), 2);
    std::vector<float> places;
    for (const shared::Light& light : shadows.ordered()) places.push_back(light.position.x);
    EXPECT_EQ(places, (std::vector<float>{0, 1, 3, 0, 2, 4}));
    EXPECT_EQ(shadows.count_unshadowed(), 3u);
    shadows.update(lights, camera_at(0, 3), 0);
    EXPECT_EQ(shadows.count_unshadowed(), 5u) << "the rectangle is not plain";
}

// A point on the edge of the cone or of the face is inside of the map, with the margin around it.
TEST(LampChoice, ViewsHaveAMargin) {
    std::vector<shared::Light> lights = render::gpu_lights(
        std::vector{lamp_at(scene::LightType::spot, 2), lamp_at(scene::LightType::point, 5)}, 0);
    for (shared::Light& light : lights) {
        light.range_m = 4;
        light.half_size_m = {0, 0};
    }
    render::LampShadows shadows;
    shadows.update(lights, camera_at(0, 3), 7);
    for (const shared::Light& light : shadows.lights()) {
        const bool is_spot = light.type == shared::kLightSpot;
        const glm::vec3 edge =
            is_spot ? light.direction + std::tan(0.5f) * light.side : glm::vec3(1, 0.3f, -1);
        const shared::ViewConstants& view = shadows.views()[light.shadow - kFirst];
        const glm::vec4 at = view.view_projection * glm::vec4(light.position + 3.0f * edge, 1);
        EXPECT_NEAR(at.x / at.w, 1 / shared::kLampMapMargin, 1e-5f);
        // The far plane is at the range of the lamp, 4 m.
        EXPECT_NEAR(at.z / at.w, shared::kLampMapNear_m * (1.0f / 3 - 1.0f / 4), 1e-6f);
    }
}

}  // namespace
}  // namespace weft::test

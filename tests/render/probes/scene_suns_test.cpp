// Tests the shadow maps of directional lights over all objects that do not move.
#include <gtest/gtest.h>

#include "render/views/further_suns.h"

namespace weft::render {
namespace {

shared::Light lamp() {
    shared::Light light{};
    light.type = shared::kLightPoint;
    return light;
}

shared::Light directional(const glm::vec3& direction) {
    shared::Light light{};
    light.type = shared::kLightDirectional;
    light.direction = glm::normalize(direction);
    return light;
}

// The corners of the box around the objects are within the map, and the first light has one, too. Objects
// that move and lights of other types change nothing.
TEST(SceneSuns, TheirMapsCoverAllObjectsThatDoNotMove) {
    const std::vector<shared::Light> lights{directional({0.2f, -1, 0.4f}), directional({0, -1, 0}), lamp()};
    const scene::Bounds still{{-10, 0, -4}, {30, 8, 6}};
    FurtherSunSizes sizes;
    sizes.scene = {512, 256, 256, 0};
    const FurtherSunMaps maps = further_sun_maps(lights, still, still, sizes);
    const FurtherSunMaps moved = further_sun_maps(lights, {{-90, 0, -4}, {30, 80, 6}}, still, sizes);
    for (size_t i = 0; i < 2; ++i) {
        const shared::FurtherSun& map = maps.constants.scene[i];
        EXPECT_EQ(moved.constants.scene[i].world_to_map, map.world_to_map) << i;
        EXPECT_NEAR(map.texel_m, glm::length(still.max - still.min) / static_cast<float>(sizes.scene[i]),
                    0.01f);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec3 at((corner & 1) != 0 ? still.min.x : still.max.x,
                               (corner & 2) != 0 ? still.min.y : still.max.y,
                               (corner & 4) != 0 ? still.min.z : still.max.z);
            const glm::vec4 place = map.world_to_map * glm::vec4(at, 1);
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GT(place[axis], 0);
                EXPECT_LT(place[axis], 1);
            }
            const glm::vec4 clip = maps.scene_views[i].view_projection * glm::vec4(at, 1);
            EXPECT_NEAR(clip.x * 0.5f + 0.5f, place.x, 1e-5f);
            EXPECT_NEAR(clip.y * 0.5f + 0.5f, place.y, 1e-5f);
            EXPECT_NEAR(clip.z, place.z, 1e-5f);
        }
    }
    EXPECT_EQ(maps.constants.scene[2].texel_m, 0) << "a lamp";
    EXPECT_EQ(maps.constants.items[0].texel_m, 0) << "the graph draws no such map";
}

}  // namespace
}  // namespace weft::render

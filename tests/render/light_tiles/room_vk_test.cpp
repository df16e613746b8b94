// Counts unnecessary entries of the light lists in a room at 1080p with 3,072 lights: floor, columns, spheres
// and a far wall, with lights anywhere inside. The limits (`most_in_vain_percent`) are the results of another
// culling method. It divides each tile into depth slices, and tests each light against the box of each slice
// that contains a pixel.
#include <random>

#include "tests/render/light_tiles/tile_fixture.h"

namespace weft::test {
namespace {

struct Radii {
    const char* name;
    float least_m, most_m;
    double most_in_vain_percent;
};

class ReferenceRoom : public TileTest, public testing::WithParamInterface<Radii> {};

scene::Scene room(const Radii& radii) {
    std::mt19937 engine(5);
    const auto unit = [&] { return static_cast<float>(engine() >> 8u) / 16777216.0f; };
    scene::Scene scene;
    scene.bounds.min = {-8, -2, -60};
    scene.bounds.max = {8, 6, 0};
    for (int i = 0; i < 3072; ++i) {
        scene::Light light;
        const float x = unit(), y = unit(), z = unit();
        light.position = {-8 + 16 * x, -2 + 8 * y, -2 - 58 * z};
        light.range_m = radii.least_m + (radii.most_m - radii.least_m) * unit();
        scene.lights.push_back(light);
    }
    scene::Camera camera;
    camera.fov_y_rad = 1.0471975512f;
    scene.cameras = {camera};
    return scene;
}

TEST_P(ReferenceRoom, ListsFewLightsInVain) {
    const scene::Scene scene = room(GetParam());
    const TileFrame frame = tiles("room.json", scene, scene.cameras[0], {1920, 1080, 1},
                                  {{"maxLights", 3072}, {"lightsPerTile", 1024}},
                                  {"depth", "lights", "tileLights", "tileOverflow"});
    ASSERT_FALSE(frame.tile_lights.empty());
    const Comparison sum = compare(frame);
    std::printf("radii %s: %.2f lights a tile, %.2f needed, %zu missed, %.1f %% in vain\n", GetParam().name,
                static_cast<double>(sum.listed) / frame.tiles(),
                static_cast<double>(sum.needed) / frame.tiles(), sum.missed, sum.in_vain_percent());
    EXPECT_EQ(frame.overflow.at(0), 0u);
    EXPECT_EQ(sum.missed, 0u);
    EXPECT_LE(sum.in_vain_percent(), GetParam().most_in_vain_percent);
}

INSTANTIATE_TEST_SUITE_P(Radii, ReferenceRoom,
                         testing::Values(Radii{"small", 0.3f, 0.8f, 28}, Radii{"medium", 0.5f, 2, 12},
                                         Radii{"large", 2, 5, 4}),
                         [](const testing::TestParamInfo<Radii>& radii) {
                             return std::string(radii.param.name);
                         });

}  // namespace
}  // namespace weft::test

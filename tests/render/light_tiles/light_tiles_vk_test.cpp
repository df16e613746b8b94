// Tests the light list of each screen tile: it contains every light that reaches one of the tile's pixels, is
// sorted, and is the same in every run. Lights that do not fit into a list are counted.
#include <algorithm>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "scene/builtin/seeded_lights.h"
#include "tests/render/light_tiles/tile_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kSize{320, 180, 1};
constexpr const char* kGraph = "tiles.json";

// Returns a built-in scene with `lights` lights. One of them is directional: directional lights must never be
// in a list.
scene::Scene scene_with(const char* name, uint32_t lights) {
    Result<scene::Scene> scene = scene::make_builtin(name);
    EXPECT_TRUE(scene);
    scene->lights = scene::seeded_lights(*scene, lights - 1, 7);
    scene::Light sun;
    sun.type = scene::LightType::directional;
    sun.intensity = 1;
    scene->lights.push_back(sun);
    return std::move(*scene);
}

// Moves the whole scene away from the origin, to a place where float has few fractional digits.
void move_away(scene::Scene& scene, const glm::vec3& by) {
    const glm::mat4 move = glm::translate(glm::mat4(1), by);
    for (scene::Instance& instance : scene.instances) instance.transform = move * instance.transform;
    for (scene::Light& light : scene.lights) light.position += by;
    for (scene::Camera& camera : scene.cameras) camera.transform = move * camera.transform;
}

// Returns `count` cameras: the scene's own cameras first, then views from inside the scene's bounds in all
// directions.
std::vector<scene::Camera> cameras(const scene::Scene& scene, size_t count) {
    std::vector<scene::Camera> found = scene.cameras;
    const glm::vec3 size = scene.bounds.max - scene.bounds.min;
    for (size_t i = found.size(); i < count; ++i) {
        const auto turn = 2.4f * static_cast<float>(i);
        const glm::vec3 eye = scene.bounds.min + size * glm::vec3(0.5f + 0.3f * std::sin(turn), 0.4f,
                                                                  0.5f + 0.3f * std::cos(turn));
        const glm::vec3 at = eye + glm::vec3(std::cos(turn), -0.2f, std::sin(turn));
        scene::Camera camera;
        camera.name = "inner " + std::to_string(i);
        camera.transform = glm::inverse(glm::lookAt(eye, at, glm::vec3(0, 1, 0)));
        found.push_back(camera);
    }
    found.resize(count);
    return found;
}

class LightTiles : public TileTest {
 protected:
    TileFrame frame_of(const scene::Scene& scene, const scene::Camera& camera, Extent3D size = kSize,
                       uint32_t lights_per_tile = 1024) {
        return tiles(
            kGraph, scene, camera, size,
            {{"maxLights", static_cast<double>(scene.lights.size())}, {"lightsPerTile", lights_per_tile}},
            {"depth", "lights", "tileLights", "tileOverflow", "tileMask", "glassDepth", "glassLights"});
    }
    static void expect_nothing_missed(const TileFrame& frame, const std::string& what) {
        ASSERT_FALSE(frame.tile_lights.empty());
        ASSERT_EQ(frame.overflow.at(0), 0u) << "a list that is cut off proves nothing";
        const Comparison sum = compare(frame);
        std::printf("%s: %zu listed, %zu needed, %zu missed, %.1f %% in vain\n", what.c_str(), sum.listed,
                    sum.needed, sum.missed, sum.in_vain_percent());
        EXPECT_EQ(sum.missed, 0u) << what;
        EXPECT_GT(sum.needed, 0u) << what;
    }
};

TEST_F(LightTiles, MissNoLight) {
    for (const char* name : {"lights", "cornell"}) {
        const scene::Scene scene = scene_with(name, 1024);
        for (const scene::Camera& camera : cameras(scene, 2))
            expect_nothing_missed(frame_of(scene, camera), std::string(name) + ", " + camera.name);
    }
}

TEST_F(LightTiles, MissNoLightFarFromTheOrigin) {
    scene::Scene scene = scene_with("spheres", 300);
    move_away(scene, {5000, 200, -3000});
    expect_nothing_missed(frame_of(scene, scene.cameras.at(0)), "far away");
}

// Returns the scene with 1024 lights, each in front of a visible surface point, with a range that ends just
// behind the point. The scene tests the tolerance for rounding in the shaders that cull lights. All points of
// a wall that faces the camera have nearly the same depth. Without the tolerance, a rounding error could
// remove a light whose range ends just behind the wall.
scene::Scene lights_that_just_reach(const scene::Scene& scene, const scene::Camera& camera,
                                    const TileFrame& frame) {
    std::mt19937 engine(3);
    const auto unit = [&] { return static_cast<double>(engine()) / 4294967296.0; };
    std::vector<glm::dvec3> places;
    for (const std::vector<glm::dvec3>& tile : tile_places(frame.depth, frame.size, frame.view))
        places.insert(places.end(), tile.begin(), tile.end());
    const glm::dvec3 to_camera(camera.transform[2]);
    scene::Scene with = scene;
    with.lights.clear();
    for (int i = 0; i < 1024; ++i) {
        const glm::dvec3& place = places.at(static_cast<size_t>(unit() * static_cast<double>(places.size())));
        scene::Light light;
        light.position = glm::vec3(place + to_camera * (0.1 + unit()));
        light.range_m = static_cast<float>(glm::length(place - glm::dvec3(light.position)) * (1 + 1e-7));
        with.lights.push_back(light);
    }
    return with;
}

TEST_F(LightTiles, MissNoLightThatJustReachesAPixel) {
    for (const glm::vec3& away : {glm::vec3(0), glm::vec3(500, 20, -300)}) {
        scene::Scene scene = scene_with("cornell", 2);
        move_away(scene, away);
        const scene::Camera& camera = scene.cameras.at(0);
        const TileFrame first = frame_of(scene, camera);
        ASSERT_FALSE(first.depth.empty());
        expect_nothing_missed(frame_of(lights_that_just_reach(scene, camera, first), camera), "just reached");
    }
}

TEST_F(LightTiles, AreSortedAndTheSameInEveryRun) {
    const scene::Scene scene = scene_with("lights", 1024);
    const TileFrame frame = frame_of(scene, scene.cameras.at(0)),
                    again = frame_of(scene, scene.cameras.at(0));
    ASSERT_FALSE(frame.tile_lights.empty());
    for (uint32_t tile = 0; tile < frame.tiles(); ++tile) {
        const std::vector<uint32_t> list = list_of(frame, frame.tile_lights, tile);
        EXPECT_TRUE(std::ranges::adjacent_find(list, std::greater_equal{}) == list.end()) << tile;
        EXPECT_EQ(list, list_of(again, again.tile_lights, tile)) << tile;
        EXPECT_TRUE(list.empty() || list.front() >= frame.directional) << tile;
    }
    EXPECT_EQ(frame.mask, again.mask);
}

TEST_F(LightTiles, HaveTheSameSetsAsBits) {
    const scene::Scene scene = scene_with("lights", 1000);
    const TileFrame frame = frame_of(scene, scene.cameras.at(0));
    const size_t words = (scene.lights.size() + 31) / 32;
    ASSERT_EQ(frame.mask.size(), words * frame.tiles());
    for (uint32_t tile = 0; tile < frame.tiles(); ++tile) {
        std::vector<uint32_t> wanted(words);
        for (const uint32_t light : list_of(frame, frame.tile_lights, tile))
            wanted.at(light / 32) |= 1u << light % 32;
        const auto first = frame.mask.begin() + static_cast<std::ptrdiff_t>(tile * words);
        EXPECT_TRUE(std::equal(wanted.begin(), wanted.end(), first)) << tile;
    }
}

TEST_F(LightTiles, CountWhatHasNoRoom) {
    constexpr uint32_t kRoom = 12;
    const scene::Scene scene = scene_with("lights", 512);
    const TileFrame whole = frame_of(scene, scene.cameras.at(0)),
                    cut = frame_of(scene, scene.cameras.at(0), kSize, kRoom);
    size_t overflowed = 0, lists = 0, longest = 0;
    for (uint32_t tile = 0; tile < whole.tiles(); ++tile) {
        std::vector<uint32_t> list = list_of(whole, whole.tile_lights, tile);
        if (list.size() > kRoom) {
            overflowed += list.size() - kRoom;
            ++lists;
            longest = std::max(longest, list.size());
            list.resize(kRoom);
        }
        EXPECT_EQ(list, list_of(cut, cut.tile_lights, tile)) << tile;
    }
    std::printf("%zu lights have no room in %zu lists of %u\n", overflowed, lists, kRoom);
    EXPECT_GT(overflowed, 0u);
    EXPECT_EQ(cut.overflow.at(0), overflowed);
    EXPECT_EQ(cut.overflow.at(1), lists);
    EXPECT_EQ(cut.overflow.at(2), longest);
    EXPECT_EQ(cut.mask, whole.mask) << "bits have no limit";
}

// Returns positions where glass could be lit: in each pixel that shows glass, 41 positions from the nearest
// pane to the surface behind it, or to 200 m if there is no surface.
TilePlaces glass_places(const TileFrame& frame) {
    TilePlaces places(frame.tiles());
    const glm::dmat4 to_world = glm::inverse(glm::dmat4(frame.view.projection) * glm::dmat4(frame.view.view));
    for (uint32_t y = 0; y < frame.size.height; ++y)
        for (uint32_t x = 0; x < frame.size.width; ++x) {
            const size_t pixel = size_t{y} * frame.size.width + x;
            if (frame.glass_depth[pixel] <= 0) continue;
            const double near_m = frame.view.near_m, from_m = near_m / frame.glass_depth[pixel];
            const double to_m = frame.depth[pixel] > 0 ? near_m / frame.depth[pixel] : 200;
            for (int i = 0; i <= 40; ++i) {
                const double m = from_m * std::pow(to_m / from_m, i / 40.0);
                const glm::dvec4 place =
                    to_world * glm::dvec4((x + 0.5) / frame.size.width * 2 - 1,
                                          (y + 0.5) / frame.size.height * 2 - 1, near_m / m, 1);
                places[y / kTilePx * frame.across() + x / kTilePx].emplace_back(glm::dvec3(place) / place.w);
            }
        }
    return places;
}

TEST_F(LightTiles, ForTransparentSurfacesReachFromTheNearestToWhatIsBehindAll) {
    const scene::Scene scene = scene_with("lights", 256);
    const TileFrame frame = frame_of(scene, scene.cameras.at(0));
    std::vector<BoundingSphere> spheres;
    for (const shared::Light& light : frame.lights) spheres.push_back(sphere_around(light));
    const TilePlaces places = glass_places(frame);
    size_t listed = 0, needed = 0, missed = 0, without = 0;
    for (uint32_t tile = 0; tile < frame.tiles(); ++tile) {
        const std::vector<uint32_t> list = list_of(frame, frame.glass_lights, tile);
        if (places[tile].empty()) {
            ++without;
            EXPECT_TRUE(list.empty()) << tile;
        }
        listed += list.size();
        for (const uint32_t light : lights_of_tile(places[tile], frame.lights, spheres, frame.directional)) {
            ++needed;
            missed += std::ranges::binary_search(list, light) ? 0u : 1u;
        }
    }
    std::printf("glass: %zu listed, %zu needed, %zu missed; %zu tiles have none\n", listed, needed, missed,
                without);
    EXPECT_EQ(missed, 0u);
    EXPECT_GT(needed, 1000u);
    EXPECT_LT(listed, needed * 2) << "far too many";
}

struct Many {
    const char* scene;
    uint32_t lights;
};

class ManyLightTiles : public LightTiles, public testing::WithParamInterface<Many> {};

TEST_P(ManyLightTiles, MissNoLightInAnyView) {
    if (std::getenv("WEFT_EXTENDED") == nullptr) GTEST_SKIP() << "only with WEFT_EXTENDED";
    const auto& [name, lights] = GetParam();
    const scene::Scene scene = scene_with(name, lights);
    for (const Extent3D& size : {kSize, Extent3D{641, 361, 1}, Extent3D{1366, 768, 1}})
        for (const scene::Camera& camera : cameras(scene, 5))
            // The length of each tile's list is limited to 4096 lights, because longer lists would need
            // larger buffers than some devices support.
            expect_nothing_missed(frame_of(scene, camera, size, std::min(lights, 4096u)),
                                  std::string(name) + ", " + std::to_string(lights) + " lights, " +
                                      camera.name + ", " + std::to_string(size.width) + " × " +
                                      std::to_string(size.height));
}

INSTANTIATE_TEST_SUITE_P(Scenes, ManyLightTiles,
                         testing::Values(Many{"lights", 256}, Many{"lights", 1024}, Many{"lights", 3072},
                                         Many{"lights", 16384}, Many{"spheres", 256}, Many{"spheres", 1024},
                                         Many{"spheres", 3072}, Many{"spheres", 16384}, Many{"cornell", 256},
                                         Many{"cornell", 1024}, Many{"cornell", 3072},
                                         Many{"cornell", 16384}),
                         [](const testing::TestParamInfo<Many>& many) {
                             return std::string(many.param.scene) + std::to_string(many.param.lights);
                         });

}  // namespace
}  // namespace weft::test

// Purpose: tests the places of light probes in unlike scenes: no probe is inside of a wall, each point near a
// surface has a probe that it sees, and the order of the geometry does not matter.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <ctime>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <optional>
#include <set>

#include "scene/builtin/scene_parts.h"
#include "scene/procedural/procedural_mesh.h"
#include "tests/scene/probes/brute_rays.h"
#include "tests/scene/probes/probe_scenes.h"
#include "weft/scene/place_probes.h"

namespace weft::scene::test {
namespace {

// The farthest probe that a point near a surface needs, in spacings.
constexpr float kReach = 1.25f;

Probes placed(const Scene& scene, const PlacementParams& params = {}) {
    Result<Probes> probes = place_probes(scene, params);
    EXPECT_TRUE(probes) << to_text(probes.errors());
    return probes ? std::move(*probes) : Probes{};
}

std::vector<glm::vec3> places_of(const ProbeVolume& volume) {
    std::vector<glm::vec3> places;
    for (const Probe& probe : volume.probes)
        if (probe.state != ProbeState::dropped) places.push_back(position_of(volume, probe));
    return places;
}

std::string text_of(const glm::vec3& p) {
    return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ", " + std::to_string(p.z) + ")";
}

// Returns the finest cell that contains the point.
std::optional<ProbeCell> cell_at(const ProbeVolume& volume, const std::vector<ProbeCell>& cells,
                                 const glm::vec3& point) {
    for (const ProbeCell& cell : cells) {
        const float spacing_m = volume.spacing_m * static_cast<float>(volume.strides[cell.level]);
        const glm::vec3 low = volume.origin + glm::vec3(cell.at) * volume.spacing_m;
        if (glm::all(glm::lessThanEqual(low, point)) && glm::all(glm::lessThanEqual(point, low + spacing_m)))
            return cell;
    }
    return std::nullopt;
}

float spacing_of(const ProbeVolume& volume, const ProbeCell& cell) {
    return volume.spacing_m * static_cast<float>(volume.strides[cell.level]);
}

void expect_no_probe_in_walls(const BoxScene& scene, const Probes& probes) {
    const BruteRays rays(scene.scene);
    for (const glm::vec3& place : places_of(probes.volume)) {
        EXPECT_FALSE(scene.is_inside(place)) << text_of(place);
        EXPECT_LT(rays.back_share(place), 0.33) << text_of(place);
    }
    for (const ReflectionProbe& probe : probes.reflections)
        EXPECT_FALSE(scene.is_inside(probe.position)) << text_of(probe.position);
}

// Each free point near a surface is in a cell, and sees a probe of this cell, or another one at most kReach
// spacings away. Nearly all points see a probe of their cell.
void expect_covered(const BoxScene& scene, const Probes& probes) {
    const BruteRays rays(scene.scene);
    const ProbeVolume& volume = probes.volume;
    const std::vector<glm::vec3> places = places_of(volume);
    const std::vector<ProbeCell> cells = cells_of(volume);
    uint32_t free = 0, uncovered = 0, dark = 0;
    for (const glm::vec3& point : rays.points_before_surfaces(0.1f, 6)) {
        if (scene.is_near(point, 0.05f)) continue;
        ++free;
        const std::optional<ProbeCell> cell = cell_at(volume, cells, point);
        EXPECT_TRUE(cell) << text_of(point) << " is in no cell";
        if (!cell) continue;
        const float reach_m = kReach * spacing_of(volume, *cell);
        const bool lit = std::ranges::any_of(cell->corners, [&](uint32_t corner) {
            return corner != ProbeCell::kNoProbe &&
                   rays.sees(point, position_of(volume, volume.probes.at(corner)));
        });
        const bool covered = lit || std::ranges::any_of(places, [&](const glm::vec3& place) {
                                 return glm::distance(place, point) <= reach_m && rays.sees(point, place);
                             });
        uncovered += covered ? 0 : 1;
        dark += lit ? 0 : 1;
    }
    EXPECT_GT(free, 20u);
    // In a corner of three walls, the nearest grid points can be inside of walls.
    EXPECT_LE(uncovered, free / 200) << "of " << free;
    EXPECT_LE(dark, free / 20) << "of " << free;
}

void expect_same_for_other_order(const Scene& scene, const Probes& probes) {
    for (const uint32_t seed : {1u, 2u})
        EXPECT_EQ(probes_to_json(placed(shuffled(scene, seed))), probes_to_json(probes)) << "seed " << seed;
}

struct NamedScene {
    const char* name;
    BoxScene (*make)();
};

class Placement : public testing::TestWithParam<NamedScene> {};

TEST_P(Placement, KeepsTheRules) {
    const BoxScene scene = GetParam().make();
    const Probes probes = placed(scene.scene);
    EXPECT_LE(places_of(probes.volume).size(), kMostIrradianceProbes);
    EXPECT_LE(probes.reflections.size(), kMostReflectionProbes);
    EXPECT_GE(probes.reflections.size(), 1u);
    expect_no_probe_in_walls(scene, probes);
    expect_covered(scene, probes);
    expect_same_for_other_order(scene.scene, probes);
}

// If all objects move or turn together, the probes move with them. So the light stays the same.
TEST_P(Placement, MovesWithTheScene) {
    const BoxScene still = GetParam().make();
    const ProbeVolume before = placed(still.scene).volume;
    const auto turn = [](float angle_deg) {
        return glm::rotate(glm::mat4(1), glm::radians(angle_deg), glm::vec3(0, 1, 0));
    };
    for (const glm::mat4& motion :
         {glm::translate(glm::mat4(1), glm::vec3(0.25f)),
          glm::translate(glm::mat4(1), glm::vec3(0.31f, 0.17f, 0.43f)),
          glm::translate(glm::mat4(1), glm::vec3(-7.7f, 2.1f, 0)), turn(37), turn(-12.3f),
          glm::translate(glm::mat4(1), glm::vec3(3.1f, 0, -0.7f)) * turn(30)}) {
        Scene moved = still.scene;
        for (Instance& instance : moved.instances) instance.transform = motion * instance.transform;
        const ProbeVolume after = placed(moved).volume;
        ASSERT_EQ(before.probes.size(), after.probes.size());
        for (size_t i = 0; i < before.probes.size(); ++i) {
            EXPECT_EQ(before.probes[i].at, after.probes[i].at);
            EXPECT_EQ(before.probes[i].state, after.probes[i].state);
            const glm::vec4 wanted = motion * glm::vec4(position_of(before, before.probes[i]), 1);
            EXPECT_LE(glm::distance(glm::vec3(wanted), position_of(after, after.probes[i])), 2e-3f);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Placement,
                         testing::Values(NamedScene{"court", open_court}, NamedScene{"corridor", corridor},
                                         NamedScene{"object", object_in_the_open},
                                         NamedScene{"floors", two_floors},
                                         NamedScene{"rooms", room_in_a_room},
                                         NamedScene{"ground", house_on_wide_ground}),
                         [](const auto& scene) { return std::string(scene.param.name); });

// The probes are too few for the spacing that the rooms need, but each room has one.
TEST(PlacementInApartments, EachRoomHasAProbe) {
    const BoxScene scene = apartments();
    const Probes probes = placed(scene.scene);
    expect_no_probe_in_walls(scene, probes);
    std::map<std::array<int, 3>, uint32_t> rooms;
    for (const glm::vec3& place : places_of(probes.volume)) {
        const glm::ivec3 room(glm::floor(place / 2.9f));
        ++rooms[{room.x, room.y, room.z}];
    }
    uint32_t with_probe = 0;
    for (int i = 0; i < 50; ++i) with_probe += rooms.contains({i % 5, i / 25, i / 5 % 5}) ? 1 : 0;
    EXPECT_EQ(with_probe, 50u);
}

// Above the terrain, and near the camera with the finest spacing.
TEST(PlacementOnTerrain, LevelsSurroundTheCamera) {
    const Scene scene = terrain(96);
    PlacementParams params;
    params.camera = glm::vec3(100, terrain_height(100, -50) + 1.7f, -50);
    const Probes probes = placed(scene, params);
    ASSERT_TRUE(probes.volume.around_camera);
    ASSERT_EQ(probes.volume.strides.size(), 3u);
    const std::vector<glm::vec3> places = places_of(probes.volume);
    EXPECT_GT(places.size(), 200u);
    EXPECT_LE(places.size(), kMostIrradianceProbes);
    float farthest_m = 0;
    for (const glm::vec3& place : places) {
        // The triangles of the terrain are up to 1 m below the curved surface.
        EXPECT_GT(place.y, terrain_height(place.x, place.z) - 1) << text_of(place);
        farthest_m = std::max(farthest_m, glm::distance(place, *params.camera));
    }
    EXPECT_GT(farthest_m, 64);
    const std::optional<ProbeCell> at_camera =
        cell_at(probes.volume, cells_of(probes.volume), *params.camera);
    ASSERT_TRUE(at_camera);
    EXPECT_LE(spacing_of(probes.volume, *at_camera), 2);
    expect_same_for_other_order(scene, placed(scene));
}

// A step of the camera inside of a cell of the finest level changes nothing. After a longer step, most grid
// points are the same.
TEST(PlacementOnTerrain, MostProbesStayWhenTheCameraMoves) {
    const Scene scene = terrain(96);
    const auto at = [&](float x) {
        PlacementParams params;
        params.camera = glm::vec3(x, terrain_height(x, 0) + 1.7f, 1);
        return placed(scene, params).volume;
    };
    const ProbeVolume first = at(0.5f), same = at(0.6f), moved = at(6.5f);
    EXPECT_EQ(probes_to_json({first, {}}), probes_to_json({same, {}}));
    std::set<std::array<int, 3>> points;
    for (const Probe& probe : first.probes) points.insert({probe.at.x, probe.at.y, probe.at.z});
    size_t kept = 0;
    for (const Probe& probe : moved.probes) kept += points.count({probe.at.x, probe.at.y, probe.at.z});
    EXPECT_NE(probes_to_json({first, {}}), probes_to_json({moved, {}}));
    EXPECT_GT(kept * 2, first.probes.size());
}

// Prints the time of the placement.
void place_and_measure(const char* name, const Scene& scene) {
    const uint64_t triangles = scene.instances.size() * scene.meshes[0].indices.size() / 3;
    ASSERT_GT(triangles, 1'000'000u);
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t cpu_begin = std::clock();
    const Probes probes = placed(scene);
    const double cpu_s = static_cast<double>(std::clock() - cpu_begin) / CLOCKS_PER_SEC;
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    std::printf("%s, %zu triangles: %.2f s, of the processors %.2f s\n", name, triangles, time.count(),
                cpu_s);
    EXPECT_GT(places_of(probes.volume).size(), 100u);
}

TEST(PlacementOfAMillionTriangles, Terrain) {
    place_and_measure("terrain", terrain(708));
}

// Spheres that fill a part of a space of 20 × 6 × 20 m.
TEST(PlacementOfAMillionTriangles, Clutter) {
    Scene scene;
    const uint32_t stone = add_matt(scene, "stone", glm::vec3(0.5f));
    MeshBuilder builder;
    builder.add_sphere(glm::vec3(0), 0.3f, 32, 16);
    place(scene, builder.finish("sphere"), stone);
    std::mt19937 random(5);
    const auto below = [&](float most) { return most * static_cast<float>(random() % 10'007) / 10'007.0f; };
    for (int i = 0; i < 1100; ++i) {
        Instance instance = scene.instances.front();
        instance.transform[3] = glm::vec4(below(20), below(6), below(20), 1);
        scene.instances.push_back(instance);
    }
    place_and_measure("clutter", scene);
}

}  // namespace
}  // namespace weft::scene::test

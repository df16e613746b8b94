// Purpose: tests that the light of probes reaches the surfaces. The light of a point is interpolated between
// the corners of the finest cell around it, so one of these corners must have a probe that sees the point.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "scene/probes/settle_probe.h"
#include "tests/scene/probes/brute_rays.h"
#include "tests/scene/probes/probe_scenes.h"
#include "weft/scene/load_gltf.h"
#include "weft/scene/place_probes.h"

namespace weft::scene::test {
namespace {

constexpr uint32_t kSeed = 5, kPoints = 500;
// Points in front of surfaces have this distance from them.
constexpr float kBefore_m = 0.1f;

struct Coverage {
    uint32_t points = 0;
    uint32_t without_cell = 0;
    uint32_t dark = 0;  // No corner of the finest cell has a probe that sees the point.
    [[nodiscard]] double share() const {
        return 1 - static_cast<double>(without_cell + dark) / std::max(points, 1u);
    }
};

Coverage measure(const BruteRays& rays, const ProbeVolume& volume, const std::vector<glm::vec3>& points) {
    const std::vector<ProbeCell> cells = cells_of(volume);
    Coverage found;
    for (const glm::vec3& point : points) {
        ++found.points;
        const auto cell = std::ranges::find_if(cells, [&](const ProbeCell& c) {
            const glm::vec3 low = volume.origin + glm::vec3(c.at) * volume.spacing_m;
            const float size_m = volume.spacing_m * static_cast<float>(volume.strides[c.level]);
            return glm::all(glm::lessThanEqual(low, point)) &&
                   glm::all(glm::lessThanEqual(point, low + size_m));
        });
        if (cell == cells.end()) {
            ++found.without_cell;
            continue;
        }
        const bool seen = std::ranges::any_of(cell->corners, [&](uint32_t corner) {
            return corner != ProbeCell::kNoProbe &&
                   rays.sees(point, position_of(volume, volume.probes.at(corner)));
        });
        found.dark += seen ? 0 : 1;
    }
    return found;
}

Scene scene_of_file() {
    Diagnostics warnings;
    Result<Scene> scene = load_gltf(WEFT_SOURCE_DIR "/tests/reference/scenes/diorama.gltf", warnings);
    EXPECT_TRUE(scene) << to_text(scene.errors());
    return scene ? std::move(*scene) : Scene{};
}

std::vector<glm::vec3> free_points(const BoxScene& scene, const BruteRays& rays) {
    std::vector<glm::vec3> points = rays.random_points(kPoints, kBefore_m, kSeed);
    std::erase_if(points, [&](const glm::vec3& point) { return scene.is_near(point, 0.05f); });
    return points;
}

Coverage coverage_of(const Scene& scene, const std::vector<glm::vec3>& points, const BruteRays& rays,
                     const char* name) {
    const Result<Probes> probes = place_probes(scene);
    EXPECT_TRUE(probes);
    if (!probes) return {};
    const Coverage found = measure(rays, probes->volume, points);
    const uint32_t count =
        count_of(probes->volume, ProbeState::kept) + count_of(probes->volume, ProbeState::moved);
    std::printf("%s: %u probes, seed %u: %.1f %% of %u points are seen, %u are in no cell\n", name, count,
                kSeed, 100 * found.share(), found.points, found.without_cell);
    EXPECT_GT(found.points, kPoints / 4);
    return found;
}

TEST(ProbeCoverage, NearlyAllSurfacesAreSeen) {
    struct Named {
        const char* name;
        BoxScene (*make)();
    };
    std::vector<double> shares;
    for (const Named& named :
         {Named{"court", open_court}, Named{"corridor", corridor}, Named{"object", object_in_the_open},
          Named{"floors", two_floors}, Named{"rooms", room_in_a_room}, Named{"ground", house_on_wide_ground},
          Named{"apartments", apartments}}) {
        const BoxScene scene = named.make();
        const BruteRays rays(scene.scene);
        shares.push_back(coverage_of(scene.scene, free_points(scene, rays), rays, named.name).share());
    }
    const Scene file = scene_of_file();
    const BruteRays rays(file);
    std::vector<glm::vec3> points = rays.random_points(kPoints, kBefore_m, kSeed);
    const TriangleTree tree(collect_triangles(file, {}), {});
    std::erase_if(points, [&](const glm::vec3& point) { return !can_stand(tree, point, 0.05f); });
    shares.push_back(coverage_of(file, points, rays, "file").share());
    std::ranges::sort(shares);
    EXPECT_GT(shares.front(), 0.98);
    EXPECT_GT(shares[shares.size() / 2], 0.998);
}

// Closed buildings have most of their probes inside, and all of their reflection probes.
TEST(ProbeCoverage, ClosedBuildingsHaveTheirProbesInside) {
    struct Named {
        const char* name;
        BoxScene (*make)();
    };
    for (const Named& named :
         {Named{"corridor", corridor}, Named{"floors", two_floors}, Named{"rooms", room_in_a_room}}) {
        const BoxScene scene = named.make();
        const TriangleTree tree(collect_triangles(scene.scene, {}), {});
        const Result<Probes> probes = place_probes(scene.scene);
        ASSERT_TRUE(probes);
        // From inside, a surface is in each direction.
        const auto is_indoors = [&](const glm::vec3& place) {
            const std::vector<glm::dvec3> ways{{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                               {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
            return std::ranges::all_of(ways, [&](const glm::dvec3& way) {
                return tree.is_blocked({glm::dvec3(place), way});
            });
        };
        uint32_t inside = 0, outside = 0;
        for (const Probe& probe : probes->volume.probes)
            if (probe.state != ProbeState::dropped)
                ++(is_indoors(position_of(probes->volume, probe)) ? inside : outside);
        std::printf("%s: %u probes inside, %u outside\n", named.name, inside, outside);
        EXPECT_GT(inside, outside);
        for (const ReflectionProbe& probe : probes->reflections)
            EXPECT_TRUE(is_indoors(probe.position)) << named.name;
    }
}

// Of a ground without a bottom, nobody sees the back.
TEST(ProbeCoverage, NoProbeIsBelowAGround) {
    const Scene scene = terrain(96);
    const Result<Probes> probes = place_probes(scene);
    ASSERT_TRUE(probes);
    for (const Probe& probe : probes->volume.probes) {
        if (probe.state == ProbeState::dropped) continue;
        const glm::vec3 place = position_of(probes->volume, probe);
        EXPECT_GT(place.y, terrain_height(place.x, place.z) - 1);
    }
}

}  // namespace
}  // namespace weft::scene::test

// Tests the spacing of probes in rooms: at most a quarter of the smallest dimension of the room, but not
// below the finest spacing, unless this needs more probes than there are.
#include <gtest/gtest.h>

#include <cstdio>
#include <limits>

#include "scene/probes/refine_grid.h"
#include "tests/scene/probes/probe_scenes.h"
#include "weft/scene/place_probes.h"

namespace weft::scene::test {
namespace {

constexpr float kFinest_m = 0.5f;
constexpr double kPartOfRoom = 4;

// Returns how much too large the spacing of a cell is, as a factor, for the smallest room with a surface in
// it. 0: the cell has no room. The sizes of rooms are rounded, so a hundredth does not count.
double excess_of(const TriangleTree& tree, const ProbeGrid& grid, const GridCell& cell) {
    const Bounds box{grid.position(cell.at), grid.position(cell.at + glm::ivec3(cell.stride))};
    double room_m = std::numeric_limits<double>::infinity();
    for (const glm::vec3& place : places_before_surfaces(tree, box, 0.1f))
        room_m = std::min(room_m, room_size_at(tree, place));
    if (!std::isfinite(room_m)) return 0;
    return double{kFinest_m} * cell.stride / std::max(room_m / kPartOfRoom, double{kFinest_m}) / 1.01;
}

// Returns the number of probes with which all rooms have the spacing that they need. Minor probes, which can
// share their light, do not count: so there is no way with fewer probes on this grid.
size_t probes_that_rooms_need(const TriangleTree& tree, const glm::vec3& origin) {
    constexpr size_t kAny = 1'000'000;
    ProbeGrid grid(tree, origin, kFinest_m, kObjectStride, 0);
    grid.clear(8);
    std::vector<GridCell> open = grid.cells_near_surfaces(kObjectStride, kAny).value(), done;
    while (!open.empty()) {
        const GridCell cell = open.back();
        open.pop_back();
        if (cell.stride == 1 || excess_of(tree, grid, cell) <= 1) {
            done.push_back(cell);
            continue;
        }
        const std::vector<GridCell> parts = grid.parts_of(cell);
        open.insert(open.end(), parts.begin(), parts.end());
    }
    EXPECT_TRUE(grid.exchange({}, done, kAny));
    const ProbeVolume volume = grid.volume({1, 2, 4}, false);
    return static_cast<size_t>(std::ranges::count_if(volume.probes, [&](const Probe& probe) {
        return probe.state != ProbeState::dropped && !look_around(tree, position_of(volume, probe)).is_minor;
    }));
}

struct Spacing {
    size_t needed = 0;             // Number of probes with which all rooms have the spacing that they need.
    size_t rooms = 0, coarse = 0;  // Number of cells in rooms, and of those with too large a spacing.
};

Spacing room_spacing_of(const Scene& scene, const std::string& name) {
    const TriangleTree tree(collect_triangles(scene, {}), {});
    const Result<Probes> probes = place_probes(scene);
    EXPECT_TRUE(probes);
    const ProbeVolume& volume = probes->volume;
    EXPECT_EQ(volume.yaw_deg, 0);
    Spacing found{probes_that_rooms_need(tree, volume.origin)};
    const ProbeGrid grid(tree, volume.origin, volume.spacing_m, kGroundStride, 0);
    for (const ProbeCell& cell : cells_of(volume)) {
        const int stride = static_cast<int>(volume.strides[cell.level]);
        const double excess = excess_of(tree, grid, {cell.at, stride});
        found.rooms += excess > 0 ? 1 : 0;
        found.coarse += excess > 1 ? 1 : 0;
    }
    const uint32_t count = count_of(volume, ProbeState::kept) + count_of(volume, ProbeState::moved);
    std::printf("%s: %u probes, all rooms need %zu; %zu of %zu cells in rooms are too large\n", name.c_str(),
                count, found.needed, found.coarse, found.rooms);
    return found;
}

// Inner sizes of closed rooms.
TEST(ProbeSpacing, IsAtMostAQuarterOfARoom) {
    for (const glm::vec3& size : {glm::vec3(1.6f), glm::vec3(2.4f), glm::vec3(3), glm::vec3(4), glm::vec3(6),
                                  glm::vec3(4, 2.4f, 3), glm::vec3(3.2f, 2.4f, 2.4f)}) {
        BoxScene room;
        room.add_room(glm::vec3(0), size, 0.2f);
        const std::string name =
            std::to_string(size.x) + " × " + std::to_string(size.y) + " × " + std::to_string(size.z);
        const Spacing found = room_spacing_of(room.scene, name);
        EXPECT_LE(found.needed, kMostIrradianceProbes) << name;
        EXPECT_GT(found.rooms, 20u) << name;
        EXPECT_EQ(found.coarse, 0u) << name;
    }
}

// These buildings are too large: no placement on this grid keeps the rule with 255 probes.
TEST(ProbeSpacing, InLargeBuildingsNeedsTooManyProbes) {
    constexpr size_t kTooMany = 2 * size_t{kMostIrradianceProbes};
    EXPECT_GT(room_spacing_of(corridor().scene, "corridor").needed, kTooMany);
    EXPECT_GT(room_spacing_of(two_floors().scene, "floors").needed, kTooMany);
    EXPECT_GT(room_spacing_of(room_in_a_room().scene, "rooms").needed, kTooMany);
}

}  // namespace
}  // namespace weft::scene::test

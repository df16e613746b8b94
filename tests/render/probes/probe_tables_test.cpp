// Tests the tables with which shaders see the irradiance probes: numbers, places, cells and their neighbours.
#include "render/probes/probe_tables.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <random>
#include <tuple>

#include "weft/render/import_catalog.h"

namespace weft::render {
namespace {

// A volume with two levels: a block of fine grid points within a block of coarse ones. Some points are
// dropped, some probes stand beside their grid point.
scene::ProbeVolume volume_of_two_levels(uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> offset(-0.2f, 0.2f);
    scene::ProbeVolume volume;
    volume.origin = {-3, 0.25f, 7};
    volume.spacing_m = 0.75f;
    volume.strides = {1, 2};
    for (int z = -4; z <= 6; ++z)
        for (int y = -2; y <= 4; ++y)
            for (int x = -6; x <= 4; ++x) {
                const bool coarse = x % 2 == 0 && y % 2 == 0 && z % 2 == 0;
                const bool fine = std::abs(x) <= 2 && std::abs(y) <= 1 && std::abs(z) <= 2;
                // The corner of the volume is missing.
                if ((!coarse && !fine) || (x > 2 && y > 2 && z > 2)) continue;
                scene::Probe probe{{x, y, z}, coarse ? 1u : 0u};
                if (random() % 5 == 0) probe.state = scene::ProbeState::dropped;
                if (random() % 4 == 0) probe.offset = {offset(random), offset(random), offset(random)};
                volume.probes.push_back(probe);
            }
    return volume;
}

// The search that shaders make.
const shared::ProbeCell* find_cell(const ProbeTables& tables, const glm::ivec3& at, uint32_t level) {
    uint32_t slot = shared::probe_cell_slot(at, level, tables.grid.slots);
    for (uint32_t i = 0; i < tables.grid.slots; ++i, slot = (slot + 1) % tables.grid.slots) {
        const shared::ProbeCell& cell = tables.cells[slot];
        if (cell.level == shared::kEmptyProbeSlot) return nullptr;
        if (cell.level == level && cell.at == at) return &cell;
    }
    return nullptr;
}

TEST(ProbeTables, EachCellIsFoundWithItsProbesAndNeighbours) {
    for (const uint32_t seed : {1u, 2u, 3u}) {
        const scene::ProbeVolume volume = volume_of_two_levels(seed);
        const ProbeTables tables = probe_tables(volume);
        const std::vector<scene::ProbeCell> cells = scene::cells_of(volume);
        ASSERT_GT(cells.size(), 40u);
        ASSERT_EQ(tables.cells.size(), tables.grid.slots);
        ASSERT_EQ(tables.grid.slots & (tables.grid.slots - 1), 0u);
        ASSERT_GE(tables.grid.slots, 2 * cells.size());
        std::map<std::tuple<uint32_t, int, int, int>, const scene::ProbeCell*> known;
        for (const scene::ProbeCell& cell : cells)
            known[{cell.level, cell.at.x, cell.at.y, cell.at.z}] = &cell;
        int missing = 0, neighbours = 0;
        for (uint32_t level = 0; level < 2; ++level)
            for (int z = -6; z <= 8; ++z)
                for (int y = -6; y <= 6; ++y)
                    for (int x = -8; x <= 6; ++x) {
                        const auto wanted = known.find({level, x, y, z});
                        const shared::ProbeCell* found = find_cell(tables, {x, y, z}, level);
                        ASSERT_EQ(found != nullptr, wanted != known.end()) << x << " " << y << " " << z;
                        missing += found == nullptr ? 1 : 0;
                        if (found == nullptr) continue;
                        for (size_t i = 0; i < 8; ++i) {
                            const uint32_t corner = wanted->second->corners[i];
                            ASSERT_EQ(found->corners[i] == shared::kNoProbe,
                                      corner == scene::ProbeCell::kNoProbe);
                            if (corner == scene::ProbeCell::kNoProbe) continue;
                            const shared::ProbePoint& point = tables.points[found->corners[i]];
                            ASSERT_EQ(point.position, scene::position_of(volume, volume.probes[corner]));
                            ASSERT_LE(point.spacing_m, volume.spacing_m * static_cast<float>(1u << level));
                        }
                        const int stride = level == 0 ? 1 : 2;
                        for (int i = 0; i < 27; ++i) {
                            const bool exists =
                                known.contains({level, x + (i % 3 - 1) * stride, y + (i / 3 % 3 - 1) * stride,
                                                z + (i / 9 - 1) * stride});
                            ASSERT_EQ((found->neighbours >> i & 1u) != 0, exists);
                            neighbours += exists ? 1 : 0;
                        }
                    }
        EXPECT_GT(missing, 100);
        EXPECT_GT(neighbours, 500);
    }
}

TEST(ProbeTables, ProbesHaveNumbersWithoutTheDroppedOnes) {
    const scene::ProbeVolume volume = volume_of_two_levels(4);
    const ProbeTables tables = probe_tables(volume);
    std::vector<glm::vec3> places;
    for (const scene::Probe& probe : volume.probes)
        if (probe.state != scene::ProbeState::dropped) places.push_back(scene::position_of(volume, probe));
    ASSERT_LT(places.size(), volume.probes.size());
    ASSERT_EQ(tables.points.size(), places.size());
    EXPECT_EQ(tables.grid.probes, places.size());
    EXPECT_EQ(count_probes(volume), places.size());
    for (size_t i = 0; i < places.size(); ++i) EXPECT_EQ(tables.points[i].position, places[i]);
    EXPECT_EQ(tables.grid.origin, volume.origin);
    EXPECT_EQ(tables.grid.spacing_m, 0.75f);
    EXPECT_EQ(tables.grid.levels, 2u);
    EXPECT_EQ(tables.grid.strides[0], glm::uvec4(1, 2, 0, 0));
    // A probe of both levels has the spacing of the finer one, if a fine cell has it as a corner.
    for (const shared::ProbePoint& point : tables.points) {
        const glm::vec3 at = (point.position - volume.origin) / 0.75f;
        if (glm::length(at) < 0.5f) {
            EXPECT_EQ(point.spacing_m, 0.75f);
        }
        if (at.x < -3.5f) {
            EXPECT_EQ(point.spacing_m, 1.5f);
        }
    }
}

TEST(ProbeTables, WithoutProbesThereIsOneEmptySlot) {
    const ProbeTables tables = probe_tables({});
    EXPECT_EQ(tables.grid.levels, 0u);
    EXPECT_EQ(tables.grid.probes, 0u);
    ASSERT_EQ(tables.cells.size(), 1u);
    EXPECT_EQ(find_cell(tables, {0, 0, 0}, 0), nullptr);
}

// A point in front of a face is drawn in the middle of this face.
TEST(ProbeTables, AProbeHasSixFacesAsACubeMap) {
    const glm::vec3 at(1, 2, 3);
    const std::vector<shared::ViewConstants> faces = probe_face_views({{glm::vec3(9), 1}, {at, 1}});
    ASSERT_EQ(faces.size(), 12u);
    const std::vector<glm::vec3> axes{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (size_t face = 0; face < 6; ++face)
        for (size_t axis = 0; axis < 6; ++axis) {
            const glm::vec4 clip = faces[6 + face].view_projection * glm::vec4(at + 2.0f * axes[axis], 1);
            if (axis == face) {
                EXPECT_NEAR(clip.x / clip.w, 0, 1e-5f);
                EXPECT_NEAR(clip.y / clip.w, 0, 1e-5f);
                EXPECT_NEAR(clip.z / clip.w, 0.005f, 1e-6f);
            } else {
                EXPECT_LE(clip.w, 1e-5f);
            }
        }
}

TEST(ProbeImports, TheCatalogueHasTheNumberOfProbes) {
    scene::Probes probes;
    probes.volume = volume_of_two_levels(5);
    const scene::Scene scene;
    const uint32_t count = count_probes(probes.volume);
    const auto expect = [](const ImportCatalog& catalog, uint32_t wanted) {
        EXPECT_EQ(catalog.numbers.at("irradianceProbes"), wanted);
        EXPECT_EQ(catalog.imports.at("probeFaces").views, 6 * wanted);
        EXPECT_EQ(catalog.imports.at("probePoints").resource.size_bytes, 16ull * std::max(wanted, 1u));
        EXPECT_EQ(catalog.imports.at("probeGrid").resource.size_bytes, 64u);
    };
    expect(scene_imports({64, 64, 1}, &scene, &probes), count);
    expect(scene_imports({64, 64, 1}, &scene), 0);
    expect(scene_imports({64, 64, 1}), 1);
    EXPECT_TRUE(scene_imports({64, 64, 1}).imports.at("probeFaces").assumes_views);
}

}  // namespace
}  // namespace weft::render

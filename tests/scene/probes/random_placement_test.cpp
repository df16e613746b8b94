// Purpose: tests the rules for the places of light probes with random scenes, budgets and spacings.
#include <gtest/gtest.h>

#include "tests/scene/probes/brute_rays.h"
#include "tests/scene/probes/probe_scenes.h"
#include "weft/scene/place_probes.h"

namespace weft::scene::test {
namespace {

uint32_t number_of_seeds() {
    return std::getenv("WEFT_EXTENDED") != nullptr ? 300 : 24;
}

// False for a substitute, which stands elsewhere: also at another corner of the same cell.
bool is_at_corner(const ProbeVolume& volume, const ProbeCell& cell, int corner, uint32_t probe) {
    const glm::ivec3 part(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    return volume.probes.at(probe).at == cell.at + part * static_cast<int>(volume.strides[cell.level]);
}

// The substitute of a grid point is a probe that is not too far away.
void check_substitute(const ProbeVolume& volume, const Probe& probe) {
    if (!probe.substitute) return;
    const auto other = std::ranges::find(volume.probes, *probe.substitute, &Probe::at);
    ASSERT_NE(other, volume.probes.end());
    EXPECT_NE(other->state, ProbeState::dropped);
    const float spacing_m = volume.spacing_m * static_cast<float>(volume.strides[probe.level]);
    EXPECT_LE(glm::distance(position_of(volume, *other), position_of(volume, probe)), 5.2f * spacing_m);
}

void check_rules(const BoxScene& scene, const PlacementParams& params, const Probes& probes) {
    const ProbeVolume& volume = probes.volume;
    EXPECT_LE(count_of(volume, ProbeState::kept) + count_of(volume, ProbeState::moved), params.most_probes);
    const BruteRays rays(scene.scene);
    for (const Probe& probe : volume.probes) {
        if (probe.state == ProbeState::dropped) {
            check_substitute(volume, probe);
            continue;
        }
        EXPECT_FALSE(probe.substitute);
        EXPECT_FALSE(scene.is_near(position_of(volume, probe), 0));
        const float spacing_m = volume.spacing_m * static_cast<float>(volume.strides[probe.level]);
        EXPECT_LE(glm::length(probe.offset), kMostOffset * spacing_m * 1.0001f);
        EXPECT_EQ(probe.state == ProbeState::kept, probe.offset == glm::vec3(0));
    }
    for (const ProbeCell& cell : cells_of(volume)) {
        const float spacing_m = volume.spacing_m * static_cast<float>(volume.strides[cell.level]);
        for (int corner = 0; corner < 8; ++corner) {
            const uint32_t probe = cell.corners[static_cast<size_t>(corner)];
            if (probe == ProbeCell::kNoProbe || !is_at_corner(volume, cell, corner, probe)) continue;
            EXPECT_LE(glm::length(volume.probes.at(probe).offset), kMostOffset * spacing_m * 1.0001f);
        }
    }
}

TEST(RandomPlacement, KeepsTheRules) {
    uint32_t with_moved = 0, with_dropped = 0, with_levels = 0;
    for (uint32_t seed = 1; seed <= number_of_seeds(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const BoxScene scene = random_boxes(seed);
        PlacementParams params;
        params.most_probes = 8 + seed * 37 % 248;
        params.min_spacing_m = seed % 3 == 0 ? 0.25f : 0.5f;
        params.camera = glm::vec3(1, 2, 3);
        LoadOptions one_thread;
        one_thread.threads = 1;
        const Result<Probes> probes = place_probes(scene.scene, params);
        const Result<Probes> again = place_probes(shuffled(scene.scene, seed), params, {}, one_thread);
        ASSERT_TRUE(probes && again);
        EXPECT_EQ(probes_to_json(*probes), probes_to_json(*again));
        check_rules(scene, params, *probes);
        with_moved += count_of(probes->volume, ProbeState::moved) > 0 ? 1 : 0;
        with_dropped += count_of(probes->volume, ProbeState::dropped) > 0 ? 1 : 0;
        with_levels += probes->volume.strides.size() > 1 ? 1 : 0;
        if (HasFailure()) return;
    }
    EXPECT_GT(with_moved, number_of_seeds() / 4);
    EXPECT_GT(with_dropped, number_of_seeds() / 4);
    EXPECT_GT(with_levels, number_of_seeds() / 4);
}

}  // namespace
}  // namespace weft::scene::test

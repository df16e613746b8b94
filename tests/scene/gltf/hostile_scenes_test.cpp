// Purpose: tests random broken scenes. Each scene must be loaded or refused with a reason, at low cost. No
// scene may crash the process.
#include "tests/scene/gltf/hostile_scenes.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/scene/gltf/gltf_fixture.h"
#include "tests/scene/measured_child.h"

namespace weft::scene::test {
namespace {

class HostileScenes : public GltfTest {};

// If a check fails, its message contains the seed of the scene, so that the scene can be generated again.
TEST_F(HostileScenes, AreLoadedOrRefusedCheaply) {
    const char* value = std::getenv("WEFT_EXTENDED");
    const bool extended = value != nullptr && *value != '\0' && std::string(value) != "0";
    const uint32_t count = extended ? 2000 : 240;
    uint32_t loaded = 0;
    for (uint32_t seed = 1; seed <= count; ++seed) {
        write("scene.gltf", weft::test::hostile_scene(seed));
        const weft::test::Cost cost = weft::test::cost_of([&] {
            Diagnostics warnings;
            const Result<Scene> scene = load_gltf(folder_ / "scene.gltf", warnings);
            if (scene) return 0;
            return scene.errors().empty() || scene.errors().front().help.empty() ? 2 : 1;
        });
        EXPECT_TRUE(cost.finished) << "seed " << seed << " ended the process";
        EXPECT_LE(cost.answer, 1) << "seed " << seed << " was refused without a remedy";
        EXPECT_LE(cost.cpu_s, 5) << "seed " << seed;
        EXPECT_LE(cost.grown_bytes, uint64_t{1} << 30) << "seed " << seed;
        loaded += cost.answer == 0 ? 1 : 0;
    }
    // Some scenes must load and some must be refused. If nearly all scenes were refused, only the first
    // checks of the loader would be tested.
    EXPECT_GE(loaded, count / 10);
    EXPECT_LE(loaded, count * 9 / 10);
}

}  // namespace
}  // namespace weft::scene::test

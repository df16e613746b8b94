// Purpose: tests which surfaces make the inside of an object for light probes: mirrored ones do, two-sided,
// transparent and perforated ones don't, and objects that move do not count.
#include <gtest/gtest.h>

#include "tests/scene/probes/brute_rays.h"
#include "tests/scene/probes/probe_scenes.h"
#include "weft/scene/place_probes.h"

namespace weft::scene::test {
namespace {

constexpr glm::vec3 kLow{-1.82f, -1.82f, -1.82f}, kHigh{1.82f, 1.82f, 1.82f};

BoxScene one_box() {
    BoxScene scene;
    scene.add(kLow, kHigh);
    return scene;
}

ProbeVolume volume_of(const Scene& scene) {
    Result<Probes> probes = place_probes(scene);
    EXPECT_TRUE(probes);
    return probes ? probes->volume : ProbeVolume{};
}

uint32_t probes_inside(const ProbeVolume& volume, const BoxScene& scene) {
    uint32_t count = 0;
    for (const Probe& probe : volume.probes)
        count += probe.state != ProbeState::dropped && scene.is_inside(position_of(volume, probe)) ? 1 : 0;
    return count;
}

TEST(ProbeSurfaces, NoProbeIsInsideOfASolidBox) {
    BoxScene scene = one_box();
    // The grid has the phase of the larger box, so it has points at the surfaces of this one.
    scene.add(kHigh + glm::vec3(0.75f), kHigh + glm::vec3(1.55f));
    const ProbeVolume volume = volume_of(scene.scene);
    EXPECT_EQ(probes_inside(volume, scene), 0u);
    EXPECT_GT(count_of(volume, ProbeState::dropped), 0u);
    EXPECT_GT(count_of(volume, ProbeState::moved), 0u);
}

// The mirrored box consists of other triangles, so its places before surfaces and its substitutes can differ.
TEST(ProbeSurfaces, MirroredInstancesAreTheSame) {
    BoxScene scene = one_box();
    const auto probes_without_substitutes = [&] {
        ProbeVolume volume = volume_of(scene.scene);
        for (Probe& probe : volume.probes) probe.substitute.reset();
        return probes_to_json({volume, {}});
    };
    const std::string straight = probes_without_substitutes();
    scene.scene.instances[0].transform[0] *= -1.0f;
    EXPECT_EQ(probes_without_substitutes(), straight);
}

TEST(ProbeSurfaces, TransformsOfInstancesCount) {
    BoxScene scene = one_box();
    scene.scene.instances[0].transform[3] = glm::vec4(40, 0, 0, 1);
    const ProbeVolume volume = volume_of(scene.scene);
    ASSERT_FALSE(volume.probes.empty());
    for (const Probe& probe : volume.probes) EXPECT_GT(position_of(volume, probe).x, 30);
    scene.boxes[0] = {kLow + glm::vec3(40, 0, 0), kHigh + glm::vec3(40, 0, 0)};
    EXPECT_EQ(probes_inside(volume, scene), 0u);
}

TEST(ProbeSurfaces, TwoSidedMaterialsHaveNoInside) {
    BoxScene scene = one_box();
    scene.scene.materials[0].double_sided = true;
    EXPECT_GT(probes_inside(volume_of(scene.scene), scene), 0u);
}

TEST(ProbeSurfaces, TransparentMaterialsHaveNoInside) {
    BoxScene scene = one_box();
    scene.scene.materials[0].alpha_mode = AlphaMode::blend;
    EXPECT_GT(probes_inside(volume_of(scene.scene), scene), 0u);
}

TEST(ProbeSurfaces, OnlyMasksWithHolesHaveNoInside) {
    BoxScene scene = one_box();
    Material& material = scene.scene.materials[0];
    material.alpha_mode = AlphaMode::mask;
    EXPECT_EQ(probes_inside(volume_of(scene.scene), scene), 0u);
    scene.scene.textures.push_back(
        {"mask", 2, 1, ColorSpace::srgb, {{0, 0, 0, 255, 0, 0, 0, 0}, {0, 0, 0, 127}}});
    material.base_color_texture.texture = 0;
    EXPECT_GT(probes_inside(volume_of(scene.scene), scene), 0u);
    scene.scene.textures[0].mips = {{0, 0, 0, 255, 0, 0, 0, 255}, {0, 0, 0, 255}};
    EXPECT_EQ(probes_inside(volume_of(scene.scene), scene), 0u);
    scene.scene.meshes[0].colors.assign(scene.scene.meshes[0].positions.size(), glm::vec4(1, 1, 1, 0.2f));
    EXPECT_GT(probes_inside(volume_of(scene.scene), scene), 0u);
}

TEST(ProbeSurfaces, MovingInstancesDoNotCount) {
    BoxScene scene = one_box();
    scene.add({4, -1, -1}, {6, 1, 1});
    const ProbeVolume both = volume_of(scene.scene);
    scene.scene.motion.nodes.push_back({});
    scene.scene.instances[1].node = 0;
    const std::string without = probes_to_json({volume_of(scene.scene), {}});
    EXPECT_NE(without, probes_to_json({both, {}}));
    EXPECT_EQ(without, probes_to_json({volume_of(one_box().scene), {}}));
}

TEST(ProbeSurfaces, UnusableNumbersAreIgnored) {
    BoxScene scene = one_box();
    const std::string plain = probes_to_json({volume_of(scene.scene), {}});
    scene.add({0, 0, 0}, {1, 1, 1});
    for (glm::vec3& position : scene.scene.meshes[1].positions)
        position *= std::numeric_limits<float>::infinity();
    EXPECT_EQ(probes_to_json({volume_of(scene.scene), {}}), plain);
    scene.scene.instances[1].transform = glm::mat4(1e12f);
    EXPECT_EQ(probes_to_json({volume_of(scene.scene), {}}), plain);
}

TEST(ProbeSurfaces, ASceneWithoutTrianglesHasNoProbes) {
    const Result<Probes> probes = place_probes(Scene{});
    ASSERT_TRUE(probes);
    EXPECT_TRUE(probes->volume.probes.empty());
    EXPECT_TRUE(probes->reflections.empty());
}

TEST(ProbeSurfaces, TheMemoryOfTheSceneIsLimited) {
    const BoxScene scene = one_box();
    SceneLimits limits;
    limits.memory_bytes = 12 * 70;
    const Result<Probes> probes = place_probes(scene.scene, {}, limits);
    ASSERT_FALSE(probes);
    EXPECT_EQ(probes.errors()[0].code, "S199");
    EXPECT_NE(to_text(probes.errors()[0]).find("--probes FILE"), std::string::npos);
}

}  // namespace
}  // namespace weft::scene::test

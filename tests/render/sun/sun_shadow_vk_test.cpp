// Tests the shadows of the sun: their edges must be at the right places, and must not move with the camera.
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/shading/quad_scene.h"
#include "tests/render/sun/box_outline.h"
#include "tests/render/sun/sun_fixture.h"

namespace weft::test {
namespace {

scene::Scene box_scene(const glm::vec3& to_sun) {
    scene::Scene scene;
    scene.meshes = {ground_mesh(), box_mesh(kBoxLeast, kBoxMost)};
    scene.materials.emplace_back();
    scene.instances = {{"ground", 0, 0, glm::mat4(1)}, {"box", 1, 0, glm::mat4(1)}};
    scene::Light light;
    light.type = scene::LightType::directional;
    light.direction = -glm::normalize(to_sun);
    scene.lights.push_back(light);
    scene::Camera camera;
    camera.transform = glm::inverse(glm::lookAt(glm::vec3(1, 3, 4), glm::vec3(0), glm::vec3(0, 1, 0)));
    scene.cameras.push_back(camera);
    return scene;
}

class UnderATiltedSun : public SunShadows, public ::testing::WithParamInterface<float> {};

TEST_P(UnderATiltedSun, TheUmbraOfABoxEndsWhereItShould) {
    const float tilt = GetParam();
    const glm::vec3 to_sun =
        glm::normalize(glm::vec3(std::sin(tilt) * 0.8f, std::cos(tilt), std::sin(tilt) * 0.6f));
    const scene::Scene scene = box_scene(to_sun);
    const float reach = 1.6f + 2 * std::tan(tilt);
    const glm::vec3 middle = -to_sun * (1.0f / to_sun.y);
    const float step = 2 * reach / kGrid;
    const Grid grid{{middle.x - reach, 0, middle.z - reach}, {step, 0, 0}, {0, 0, step}};
    const Seen seen = look(scene, scene.cameras[0], grid);
    ASSERT_EQ(seen.share.size(), size_t{kGrid} * kGrid);
    const Outline outline{glm::dvec3(to_sun)};
    size_t edges = 0, dark = 0, wrong = 0;
    double worst = 0;
    for (uint32_t i = 0; i < kGrid * kGrid; ++i) {
        const glm::vec3 point = grid.at(i);
        if (std::max(std::abs(point.x), std::abs(point.z)) > 3.9f) continue;
        const double texel_m = texel_at(seen, point), within = outline.depth_m(glm::dvec3(point)) / texel_m;
        dark += within > 3 ? 1 : 0;
        const float wanted = within > 0 ? 0 : 1;
        wrong += std::abs(within) > 3 && std::abs(seen.share[i] - wanted) > 1e-4f ? 1 : 0;
        // Where the filtered shadow is 0.5 between this grid point and its right or lower neighbour, there is
        // an edge of the shadow.
        for (const uint32_t j : {i + 1, i + kGrid}) {
            if (j >= kGrid * kGrid || (j == i + 1 && j % kGrid == 0)) continue;
            const float a = seen.share[i] - 0.5f, b = seen.share[j] - 0.5f;
            if (a * b >= 0) continue;
            // The darker of the two points must not be outside of the umbra by more than a texel, and the
            // other point not inside of it.
            const double other = outline.depth_m(glm::dvec3(grid.at(j))) / texel_m;
            const double off = a < 0 ? std::max(-within, other) : std::max(within, -other);
            worst = std::max(worst, off);
            ++edges;
        }
    }
    std::printf("tilt %.2f: %zu points of the edge, at most %.2f texels off; %zu points in the umbra\n",
                double{tilt}, edges, worst, dark);
    EXPECT_GT(edges, 200u);
    EXPECT_GT(dark, 1000u);
    EXPECT_EQ(wrong, 0u) << "points more than 3 texels from the edge that are neither dark nor lit";
    EXPECT_LE(worst, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Radians, UnderATiltedSun, ::testing::Values(0.2f, 0.5f, 0.8f, 1.1f),
                         [](const auto& c) {
                             return "Tilt" + std::to_string(static_cast<int>(c.param * 100));
                         });

// Samples the shadow at fixed points while the camera moves in steps of 3 cm. Where the texels of the map
// keep their size, the shadow must not change, even if the map moves. Where their size changes, only the
// edges of shadows may change.
TEST_F(SunShadows, StandStillWhileTheCameraCreeps) {
    constexpr int kSteps = 6;
    const scene::Scene scene = atrium(10);
    const Grid floor{{-5, 0.05f, -6}, {10.0f / kGrid, 0, 0}, {0, 0, 12.0f / kGrid}};
    const Grid wall{{-5.2f, 4, 6}, {0, 0, -12.0f / kGrid}, {0, -4.0f / kGrid, 0}};
    size_t moved = 0;
    for (const Grid& grid : {floor, wall}) {
        scene::Camera camera = scene.cameras.at(0);
        Seen before = look(scene, camera, grid);
        ASSERT_EQ(before.share.size(), size_t{kGrid} * kGrid);
        const auto half_lit =
            std::ranges::count_if(before.share, [](float x) { return x > 0.01f && x < 0.99f; });
        const auto dark = std::ranges::count_if(before.share, [](float x) { return x < 0.01f; });
        size_t same = 0, changed = 0, resized = 0, far_off = 0;
        for (int step = 0; step < kSteps; ++step) {
            camera.transform[3] += glm::vec4(glm::normalize(glm::vec3(0.6f, -0.5f, 0.7f)) * 0.03f, 0);
            Seen after = look(scene, camera, grid);
            ASSERT_EQ(after.share.size(), before.share.size());
            for (uint32_t i = 0; i < before.sun.count; ++i)
                moved += before.sun.cascades[i].texel_m == after.sun.cascades[i].texel_m &&
                                 before.sun.cascades[i].origin_texels != after.sun.cascades[i].origin_texels
                             ? 1
                             : 0;
            for (uint32_t i = 0; i < after.share.size(); ++i) {
                const float difference = std::abs(after.share[i] - before.share[i]);
                const bool stays = maps_at(before, grid.at(i)) == maps_at(after, grid.at(i));
                (stays ? same : resized) += 1;
                // Differences up to half a step of 8 bits are tolerated.
                changed += stays && difference > 0.5f / 255 ? 1 : 0;
                far_off += difference > 0.5f ? 1 : 0;
            }
            before = std::move(after);
        }
        std::printf(
            "%zu points keep their texels, of these %zu change; of %zu others %zu change by half; %ld points "
            "dark, %ld "
            "half lit\n",
            same, changed, resized, far_off, dark, half_lit);
        EXPECT_LE(changed * 1000, same);
        EXPECT_GT(same, size_t{kSteps} * kGrid * kGrid / 2);
        EXPECT_LE(far_off * 500, same + resized);
        EXPECT_GT(half_lit, 1000);
        EXPECT_GT(dark, 5000);
    }
    EXPECT_GT(moved, 0u);
}

}  // namespace
}  // namespace weft::test

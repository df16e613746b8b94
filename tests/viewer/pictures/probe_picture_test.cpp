// Tests the picture of light probes: each kind of probe has its sign at its place, seen from above and from
// the side.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "scene/builtin/scene_parts.h"
#include "scene/procedural/procedural_mesh.h"
#include "viewer/pictures/probe_picture.h"

namespace weft::viewer {
namespace {

using Color = std::array<uint8_t, 3>;
constexpr Color kFinest{0, 114, 178}, kRing{0, 0, 0}, kCross{214, 120, 120}, kSquare{204, 0, 153},
    kSection{110, 110, 110};

struct Spot {
    uint32_t texels = 0;
    double x = 0, y = 0;  // Middle of the texels.
};

// Returns the texels of a colour in the columns from `begin` to `end`.
Spot find(const ProbePicture& picture, const Color& color, uint32_t begin, uint32_t end) {
    Spot spot;
    for (uint32_t y = 0; y < picture.height_px; ++y)
        for (uint32_t x = begin; x < end; ++x) {
            const uint8_t* texel = &picture.rgba[(size_t{y} * picture.width_px + x) * 4];
            if (texel[0] != color[0] || texel[1] != color[1] || texel[2] != color[2]) continue;
            ++spot.texels;
            spot.x += x;
            spot.y += y;
        }
    if (spot.texels > 0) spot = {spot.texels, spot.x / spot.texels, spot.y / spot.texels};
    return spot;
}

scene::Scene box_scene() {
    scene::Scene scene;
    const uint32_t wall = scene::add_matt(scene, "wall", glm::vec3(0.5f));
    scene::MeshBuilder builder;
    builder.add_box({3.5f, 0.5f, -0.5f}, {4.5f, 1.5f, 0.5f});
    scene::place(scene, builder.finish("box"), wall);
    return scene;
}

// Probes in a row along x: kept at 0, dropped at 1, moved at 2 to z = 0.4; a reflection probe at (6, 2, 0).
// The grid is 1 m above the ground.
scene::Probes row_of_probes() {
    scene::Probes probes;
    probes.volume.origin = {0, 1, 0};
    probes.volume.probes = {{{0, 0, 0}, 0, glm::vec3(0), scene::ProbeState::kept},
                            {{1, 0, 0}, 0, glm::vec3(0), scene::ProbeState::dropped},
                            {{2, 0, 0}, 0, {0, 0, 0.4f}, scene::ProbeState::moved}};
    probes.reflections = {{"far", {6, 2, 0}, std::nullopt}};
    return probes;
}

TEST(ProbePictureTest, EachProbeHasItsSignAtItsPlace) {
    const ProbePicture picture = draw_probes(box_scene(), row_of_probes());
    // The picture shows x from −1 m to 7 m. The left half is the view from above.
    const uint32_t half = picture.width_px / 2;
    const double meter = half / 8.0;
    const auto expect_at = [&](const Color& color, double x_m, double from_side) {
        const Spot above = find(picture, color, 0, half), side = find(picture, color, half, picture.width_px);
        EXPECT_GT(above.texels, 5u);
        EXPECT_GT(side.texels, 5u);
        EXPECT_NEAR(above.x, (x_m + 1) * meter, 0.2 * meter);
        EXPECT_NEAR(side.x - half, (x_m + 1) * meter, 0.2 * meter);
        EXPECT_NEAR(side.y, from_side * meter, 0.2 * meter);
    };
    // Seen from the side, the upper edge is 1 m above the reflection probe.
    expect_at(kCross, 1, 2);
    expect_at(kRing, 2, 2);
    expect_at(kSquare, 6, 1);
    expect_at(kSection, 4, 2);
    EXPECT_GT(find(picture, kFinest, 0, half).texels, 20u);
    // From above, the moved probe is below the dropped one, because z increases downwards.
    EXPECT_NEAR(find(picture, kRing, 0, half).y - find(picture, kCross, 0, half).y, 0.4 * meter, 0.1 * meter);
}

TEST(ProbePictureTest, WithoutProbesTheWholeSceneIsShown) {
    scene::Scene scene = box_scene();
    scene.bounds = world_bounds(scene);
    const ProbePicture picture = draw_probes(scene, {});
    EXPECT_GT(picture.width_px, 100u);
    EXPECT_EQ(find(picture, kFinest, 0, picture.width_px).texels, 0u);
    EXPECT_GT(find(picture, kSection, 0, picture.width_px).texels, 100u);
}

}  // namespace
}  // namespace weft::viewer

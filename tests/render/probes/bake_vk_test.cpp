// Tests of the module probe_bake: what a probe sees in scenes for which this is known exactly.
#include <functional>
#include <set>

#include "tests/render/probes/bake_fixture.h"

namespace weft::test {
namespace {

constexpr glm::vec3 kLow{-2, -1.5f, -3}, kHigh{3, 2, 2.5f};
constexpr glm::vec3 kProbePlace{0.3f, 0.2f, -0.4f};
// The walls are in the order of the faces of a cube: +x −x +y −y +z −z.
constexpr std::array<glm::vec3, 6> kColors{glm::vec3{0.8f, 0.1f, 0.1f}, {0.1f, 0.6f, 0.2f},
                                           {0.9f, 0.9f, 0.9f},          {0.3f, 0.2f, 0.1f},
                                           {0.05f, 0.1f, 0.7f},         {0.5f, 0.5f, 0.02f}};
constexpr size_t kMetalWall = 4, kBrightWall = 2;
constexpr glm::vec3 kEmission{1200, 800, 100};  // In cd/m².

glm::vec3 axis(size_t face) {
    glm::vec3 n(0);
    n[static_cast<int>(face / 2)] = face % 2 == 0 ? 1.0f : -1.0f;
    return n;
}

// Adds a rectangle that is 2 × half_m wide. Its front faces along the normal of `face` if `front` is true.
void add_rectangle(scene::Scene& scene, glm::vec3 middle, glm::vec3 normal, float half_m, uint32_t material,
                   const glm::mat4& transform = glm::mat4(1)) {
    const glm::vec3 up = std::abs(normal.y) > 0.5f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
    const glm::vec3 right = glm::cross(up, normal);
    scene::MeshBuilder builder;
    builder.add_rectangle(middle - half_m * (right + up), 2 * half_m * right, 2 * half_m * up);
    scene::place(scene, builder.finish("rectangle"), material, transform);
}

// A closed room with six walls of different materials, which face inwards.
scene::Scene room() {
    scene::Scene scene;
    for (size_t wall = 0; wall < 6; ++wall) {
        const uint32_t material = scene::add_matt(scene, "wall", kColors[wall]);
        scene.materials[material].metallic = wall == kMetalWall ? 1.0f : 0.0f;
        if (wall == kBrightWall) scene.materials[material].emissive = kEmission;
        const glm::vec3 n = axis(wall), on_wall = wall % 2 == 0 ? kHigh : kLow;
        const glm::vec3 middle = glm::mix(0.5f * (kLow + kHigh), on_wall, glm::abs(n));
        // The walls reach beyond the room, so that no ray passes between two of them.
        add_rectangle(scene, middle, -n, 4, material);
    }
    scene::finish_scene(scene, glm::vec3(0), glm::vec3(0), 0);
    return scene;
}

struct Hit {
    size_t wall = 0;
    float distance_m = 0;
    float clearance_m = 0;  // How much farther the next wall is.
};

Hit look(const glm::vec3& from, const glm::vec3& direction) {
    Hit hit{.distance_m = 1e9f};
    float second_m = 1e9f;
    for (size_t wall = 0; wall < 6; ++wall) {
        const int i = static_cast<int>(wall / 2);
        const float side = wall % 2 == 0 ? kHigh[i] : kLow[i];
        const float t = (side - from[i]) / direction[i];
        if (!(t > 0)) continue;
        second_m = std::min(second_m, std::max(t, hit.distance_m));
        if (t < hit.distance_m) {
            hit.wall = wall;
            hit.distance_m = t;
        }
    }
    hit.clearance_m = second_m - hit.distance_m;
    return hit;
}

TEST_F(ProbeBake, TheFacesOfAProbeShowTheWallsOfItsRoom) {
    const std::vector<glm::vec3> places{kProbePlace, {-1.2f, -0.8f, 1.1f}};
    const std::unique_ptr<render::Session> session = begin(room(), probes_at(places));
    ASSERT_TRUE(session);
    frame(*session);
    size_t compared = 0;
    float worst = 0;
    std::string worst_place;
    for (int i = 0; i < 2 * 6 * kBakeSide * kBakeSide; ++i) {
        const int x = i % kBakeSide, y = i / kBakeSide % kBakeSide, layer = i / (kBakeSide * kBakeSide);
        const int probe = layer / 6, face = layer % 6;
        const Hit hit = look(places[static_cast<size_t>(probe)], direction_of_texel(face, x, y));
        if (hit.clearance_m < 1e-3f) continue;
        ++compared;
        const std::string where = "probe " + std::to_string(probe) + " face " + std::to_string(face) + " (" +
                                  std::to_string(x) + ", " + std::to_string(y) + ")";
        const float error = std::abs(texel("probeDistance", probe, face, x, y).r / hit.distance_m - 1);
        ASSERT_LE(error, 1e-2f) << where;
        if (error > worst) {
            worst = error;
            worst_place = where;
        }
        const glm::vec3 n = octahedral(glm::vec2(texel("probeNormal", probe, face, x, y)));
        ASSERT_LT(glm::length(n + axis(hit.wall)), 1e-3f) << where;
        const glm::vec4 albedo = texel("probeAlbedo", probe, face, x, y);
        ASSERT_LT(glm::length(glm::vec3(albedo) - glm::sqrt(kColors[hit.wall])), 0.006f) << where;
        ASSERT_EQ(albedo.a, hit.wall == kMetalWall ? 1.0f : 0.0f) << where;
        const glm::vec3 emission = hit.wall == kBrightWall ? kEmission / 16.0f : glm::vec3(0);
        ASSERT_EQ(glm::vec3(texel("probeEmission", probe, face, x, y)), emission) << where;
    }
    std::printf("largest error of a distance: %.1e of it\n", worst);
    EXPECT_LE(worst, 2e-5f) << worst_place;
    EXPECT_GT(compared, 12000u);
}

// Returns the direction of a place in a texel of the map, from 0 to 1 along each side.
glm::vec3 direction_in_map(int texel, glm::vec2 inside) {
    glm::vec2 e =
        (glm::vec2(texel % kMapSide - 1, texel / kMapSide - 1) + inside) / float{kInnerSide} * 2.0f - 1.0f;
    // Beyond an edge, the map is turned about the middle of the edge by half a turn.
    if (std::abs(e.x) > 1) e = {std::copysign(2.0f, e.x) - e.x, -e.y};
    if (std::abs(e.y) > 1) e = {-e.x, std::copysign(2.0f, e.y) - e.y};
    return octahedral(e);
}

// Calls `visit` for 16 × 16 directions in a texel of the map.
void for_directions(int texel, const std::function<void(const glm::vec3&)>& visit) {
    constexpr int kSamples = 16;
    for (int s = 0; s < kSamples * kSamples; ++s)
        visit(direction_in_map(texel, (glm::vec2(s % kSamples, s / kSamples) + 0.5f) / float{kSamples}));
}

// Each texel has the plane of one of the walls that are seen within it, exactly, and never a plane between
// them.
TEST_F(ProbeBake, EachTexelOfTheMapHasThePlaneOfAWall) {
    const std::unique_ptr<render::Session> session = begin(room(), probes_at({kProbePlace}));
    ASSERT_TRUE(session);
    frame(*session);
    int with_edge = 0;
    double worst = 0, worst_deviation = 0;
    for (int i = 0; i < kMapSide * kMapSide; ++i) {
        std::set<size_t> walls;
        for_directions(i, [&](const glm::vec3& d) { walls.insert(look(kProbePlace, d).wall); });
        with_edge += walls.size() > 1 ? 1 : 0;
        const glm::vec4 seen = moments(0, i % kMapSide, i / kMapSide);
        double least = 1e9;
        for (const size_t wall : walls) {
            const int k = static_cast<int>(wall / 2);
            const float distance_m = std::abs((wall % 2 == 0 ? kHigh[k] : kLow[k]) - kProbePlace[k]);
            least = std::min(least, double{glm::length(glm::vec3(seen) - axis(wall) / distance_m)});
        }
        worst = std::max(worst, least);
        worst_deviation = std::max(worst_deviation, double{seen.a});
        EXPECT_LT(least, 0.002) << "texel " << i % kMapSide << ", " << i / kMapSide;
    }
    EXPECT_LT(worst_deviation, 0.03);
    EXPECT_GT(with_edge, 100);
    std::printf("%d texels see an edge; largest error of a plane %.5f/m, largest deviation %.5f/m\n",
                with_edge, worst, worst_deviation);
}

// A small wall before a large one. Where a texel sees both, it has the plane of the wall of which it sees
// more.
TEST_F(ProbeBake, ATexelOverAnEdgeHasThePlaneOfTheWallOfWhichItSeesMore) {
    constexpr float kNear = 1, kFar = 2, kHalf = 0.55f;
    scene::Scene scene;
    const uint32_t material = scene::add_matt(scene, "wall", glm::vec3(0.5f));
    add_rectangle(scene, {0, 0, -kNear}, {0, 0, 1}, kHalf, material);
    add_rectangle(scene, {0, 0, -kFar}, {0, 0, 1}, 4, material);
    scene::finish_scene(scene, glm::vec3(0), glm::vec3(0), 0);
    const std::unique_ptr<render::Session> session = begin(scene, probes_at({{0, 0, 0}}));
    ASSERT_TRUE(session);
    frame(*session);
    int near = 0, far = 0;
    for (int i = 0; i < kMapSide * kMapSide; ++i) {
        double share = 0;
        bool ahead = true;
        for_directions(i, [&](const glm::vec3& d) {
            const glm::vec2 at = glm::vec2(d) / std::abs(d.z) * kNear;
            share += std::abs(at.x) < kHalf && std::abs(at.y) < kHalf ? 1.0 / 256 : 0;
            ahead = ahead && d.z < 0 && std::abs(at.x) < 1.5f && std::abs(at.y) < 1.5f;
        });
        if (!ahead || share == 0 || share == 1 || (share > 0.3 && share < 0.7)) continue;
        const float distance_m = share > 0.5 ? kNear : kFar;
        const glm::vec3 seen(moments(0, i % kMapSide, i / kMapSide));
        EXPECT_LT(glm::length(seen - glm::vec3(0, 0, -1 / distance_m)), 0.002f)
            << "texel " << i % kMapSide << ", " << i / kMapSide << ", share " << share;
        ++(share > 0.5 ? near : far);
    }
    std::printf("%d texels see mostly the near wall, %d mostly the far one\n", near, far);
    EXPECT_GT(near, 5);
    EXPECT_GT(far, 5);
}

// The probe sees a small rectangle near each edge of the map, on one side of the middle of the edge.
TEST_F(ProbeBake, TheBorderOfAMapContinuesIt) {
    scene::Scene scene;
    const uint32_t material = scene::add_matt(scene, "rectangle", glm::vec3(0.5f));
    for (const glm::vec3& middle : {glm::vec3(-1, 0.3f, -1), glm::vec3(1.2f, -0.4f, -1),
                                    glm::vec3(0.5f, 1.4f, -1), glm::vec3(-0.4f, -1.6f, -1)})
        add_rectangle(scene, middle, {0, 0, 1}, 0.35f, material);
    scene::finish_scene(scene, glm::vec3(0), glm::vec3(0), 0);
    const std::unique_ptr<render::Session> session = begin(scene, probes_at({{0, 0, 0}}));
    ASSERT_TRUE(session);
    frame(*session);
    constexpr int kLast = kMapSide - 1;
    size_t seen = 0;
    for (int i = 1; i < kLast; ++i) {
        EXPECT_EQ(moments(0, 0, i), moments(0, 1, kLast - i)) << i;
        EXPECT_EQ(moments(0, kLast, i), moments(0, kLast - 1, kLast - i)) << i;
        EXPECT_EQ(moments(0, i, 0), moments(0, kLast - i, 1)) << i;
        EXPECT_EQ(moments(0, i, kLast), moments(0, kLast - i, kLast - 1)) << i;
        for (const glm::ivec2 at : {glm::ivec2(0, i), {kLast, i}, {i, 0}, {i, kLast}})
            seen += moments(0, at.x, at.y).b < 0 ? 1 : 0;  // The rectangles are planes of constant z.
    }
    EXPECT_EQ(moments(0, 0, 0), moments(0, kLast - 1, kLast - 1));
    EXPECT_EQ(moments(0, kLast, 0), moments(0, 1, kLast - 1));
    EXPECT_GE(seen, 4u) << "at least one texel at each edge";
}

// Each face of the probe sees another kind of surface at its middle.
TEST_F(ProbeBake, BacksOfOneSidedSurfacesAreMarked) {
    scene::Scene scene;
    const uint32_t plain = scene::add_matt(scene, "plain", glm::vec3(0.5f));
    scene.materials[plain].emissive = glm::vec3(100);
    const uint32_t two_sided = scene::add_matt(scene, "two-sided", glm::vec3(0.5f));
    scene.materials[two_sided].double_sided = true;
    scene.materials[two_sided].emissive = glm::vec3(100);
    const uint32_t holes = scene::add_matt(scene, "holes", glm::vec3(0.5f));
    scene.materials[holes].alpha_mode = scene::AlphaMode::mask;
    scene.materials[holes].base_color.a = 0.4f;
    const uint32_t glass = scene::add_matt(scene, "glass", glm::vec3(0.5f));
    scene.materials[glass].alpha_mode = scene::AlphaMode::blend;
    const glm::mat4 mirror = glm::mat4(glm::mat3(-1, 0, 0, 0, 1, 0, 0, 0, 1));
    add_rectangle(scene, {2, 0, 0}, {1, 0, 0}, 0.5f, plain);            // +x: the back
    add_rectangle(scene, {-2, 0, 0}, {-1, 0, 0}, 0.5f, two_sided);      // −x: the back
    add_rectangle(scene, {0, 2, 0}, {0, -1, 0}, 0.5f, plain, mirror);   // +y: the front of a mirrored object
    add_rectangle(scene, {0, -2, 0}, {0, -1, 0}, 0.5f, plain, mirror);  // −y: the back of a mirrored object
    add_rectangle(scene, {0, 0, 2}, {0, 0, -1}, 0.5f, holes);           // +z: a hole, and a wall behind it
    add_rectangle(scene, {0, 0, 3}, {0, 0, -1}, 1, plain);
    add_rectangle(scene, {0, 0, -2}, {0, 0, 1}, 0.5f, glass);  // −z: nothing that blocks the view
    scene::finish_scene(scene, glm::vec3(0), glm::vec3(0), 0);
    const std::unique_ptr<render::Session> session = begin(scene, probes_at({{0, 0, 0}}));
    ASSERT_TRUE(session);
    frame(*session);
    const std::array<float, 6> distances{-2, 2, 2, -2, 3, 0};
    for (int face = 0; face < 6; ++face) {
        const float wanted = distances[static_cast<size_t>(face)];
        EXPECT_NEAR(texel("probeDistance", 0, face, 16, 16).r, wanted, 0.005f) << "face " << face;
        EXPECT_EQ(texel("probeEmission", 0, face, 16, 16).r, wanted > 0 ? 100 / 16.0f : 0) << "face " << face;
        if (wanted == 0) continue;
        const glm::vec3 n = octahedral(glm::vec2(texel("probeNormal", 0, face, 16, 16)));
        EXPECT_LT(glm::length(n + axis(static_cast<size_t>(face))), 1e-3f) << "face " << face;
    }
    EXPECT_EQ(texel("probeDistance", 0, 0, 0, 0).r, 0) << "nothing is there";
}

TEST_F(ProbeBake, AProbeIsBakedAgainOnlyIfAnObjectThatStandsStillChanges) {
    scene::Scene scene = room();
    const uint32_t material = scene::add_matt(scene, "block", glm::vec3(0.5f));
    add_rectangle(scene, {0.3f, 0.2f, -1.4f}, {0, 0, 1}, 0.3f, material);
    const auto block = static_cast<uint32_t>(scene.instances.size() - 1);
    const std::unique_ptr<render::Session> session = begin(scene, probes_at({kProbePlace}));
    ASSERT_TRUE(session);
    frame_of(*session).turns["probeTurns"] = {0};
    frame(*session);
    EXPECT_EQ(ran_, 7u);
    EXPECT_NEAR(texel("probeDistance", 0, 5, 16, 16).r, 1, 0.01f);
    frame(*session);
    EXPECT_EQ(ran_, 0u) << "nothing has changed";
    frame_of(*session).camera.transform[3].x += 0.5f;
    frame(*session);
    EXPECT_EQ(ran_, 0u) << "only the camera has moved";
    frame_of(*session).transforms = {{block, glm::translate(glm::mat4(1), glm::vec3(0, 0, 0.5f))}};
    frame(*session);
    EXPECT_EQ(ran_, 7u) << "the block no longer stands still";
    EXPECT_NEAR(texel("probeDistance", 0, 5, 16, 16).r, 2.6f, 0.01f);
    frame_of(*session).transforms = {{block, glm::translate(glm::mat4(1), glm::vec3(0, 0, 0.2f))}};
    frame(*session);
    EXPECT_EQ(ran_, 0u) << "the block was moving before";
}

TEST_F(ProbeBake, AListOfTurnsChoosesTheProbes) {
    const std::unique_ptr<render::Session> session =
        begin(room(), probes_at({kProbePlace, {0, 0, 0}, {1, 1, 1}}));
    ASSERT_TRUE(session);
    frame_of(*session).turns["probeTurns"] = {2};
    frame(*session);
    EXPECT_EQ(ran_, 7u);
    EXPECT_EQ(moments(0, 5, 5).a, -1) << "not baked yet";
    EXPECT_EQ(moments(1, 5, 5).a, -1) << "not baked yet";
    EXPECT_GE(moments(2, 5, 5).a, 0);
    frame_of(*session).turns["probeTurns"] = {2, 0};
    frame(*session);
    EXPECT_EQ(ran_, 7u) << "probe 2 rests";
    EXPECT_GE(moments(0, 5, 5).a, 0);
}

TEST_F(ProbeBake, WithoutProbesNothingRuns) {
    const std::unique_ptr<render::Session> session = begin(room(), {}, {.observed = {}});
    ASSERT_TRUE(session);
    for (const PassDecl& pass : session->plan().graph.passes)
        EXPECT_FALSE(pass.name.starts_with("probeBake")) << pass.name;
}

}  // namespace
}  // namespace weft::test

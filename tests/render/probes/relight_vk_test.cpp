// Tests the light of probes: it is compared with closed forms, and with references on the CPU. See
// relight.json.
#include "tests/render/probes/relight_fixture.h"
#include "weft/scene/place_probes.h"

namespace weft::test {
namespace {

using glm::dvec3;

const std::array<dvec3, 8> kDirections{dvec3(1, 0, 0),
                                       dvec3(-1, 0, 0),
                                       dvec3(0, 1, 0),
                                       dvec3(0, -1, 0),
                                       dvec3(0, 0, 1),
                                       dvec3(0, 0, -1),
                                       glm::normalize(dvec3(1, 2, -1)),
                                       glm::normalize(dvec3(-2, 1, 3))};

TEST(ProbeReference, AProbeThatLightsItselfHasThePublishedLight) {
    for (int rounds = 1; rounds <= 4; ++rounds) {
        const Harmonics light = self_lit_box(240, 0.5, rounds);
        for (size_t i = 0; i < kBoxNormals.size(); ++i)
            EXPECT_NEAR(irradiance_of(light, kBoxNormals[i]), kBoxSelfLit[rounds - 1][i], 0.003)
                << "round " << rounds << ", normal " << i;
    }
}

// In a closed room whose walls emit the radiance 1, the radiance is 1 + ρ + ρ² + … for as many terms as
// rounds. The albedo differs between the colour channels.
TEST_F(Relight, AClosedRoomGivesTheGeometricSeries) {
    const glm::dvec3 albedo(kAlbedo02, kAlbedo05, kAlbedo08);
    const scene::Scene room = closed_room({-2, 0, -1}, {2, 3, 4}, matt(glm::vec3(albedo), glm::vec3(1)));
    const auto session = begin(room, probe_at({0.7f, 1.2f, 0.4f}), {.feedback = Feedback::self});
    ASSERT_TRUE(session);
    dvec3 radiance(0);
    for (int k = 0; k < 6; ++k) {
        radiance = radiance * albedo + 1.0;
        const std::vector<ProbeLight> light = round(*session);
        ASSERT_EQ(light.size(), 1u);
        EXPECT_TRUE(light[0].is_lit);
        for (const dvec3& n : kDirections)
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(light[0].irradiance(n)[c] / std::numbers::pi / radiance[c], 1, 2e-4)
                    << k << " bounces, channel " << c;
    }
    // The published values for the albedos 0.2, 0.5 and 0.8 differ from these by the rounding of the albedos.
    const dvec3 published(1.24992, 1.96875, 3.68928);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(radiance[c], published[c], 0.01);
}

// An endless plane under a sun at 30° and a sky of radiance 1.
TEST_F(Relight, APlaneUnderASkyIsExact) {
    scene::Scene scene;
    scene.meshes = {square_mesh()};
    scene.materials = {matt(glm::vec3(kAlbedo03))};
    constexpr float kHalf_m = 20'000;
    add_quad(scene, {0, 0, 0}, {0, 0, kHalf_m}, {kHalf_m, 0, 0});
    scene.bounds = {{-kHalf_m, 0, -kHalf_m}, {kHalf_m, 0, kHalf_m}};
    scene.lights = {sun_of({std::cos(std::numbers::pi / 6), 0.5, 0}, 10)};
    const auto session = begin(scene, probe_at({0, 2, 0}), {.feedback = Feedback::self, .sky = 1});
    ASSERT_TRUE(session);
    const std::vector<ProbeLight> light = rounds(*session, 2);
    ASSERT_EQ(light.size(), 1u);
    const double ground = double{kAlbedo03} * (5 + std::numbers::pi) / std::numbers::pi;
    EXPECT_NEAR(ground, 0.7775, 0.006);
    for (const dvec3& n : kDirections)
        EXPECT_NEAR(light[0].irradiance(n).g, std::numbers::pi * ((1 + n.y) + ground * (1 - n.y)) / 2, 1e-3);
}

// Returns the sphere of radius 3 around the origin, seen from inside, with the part within `cap_rad` of +y as
// a mesh of its own.
scene::Scene sphere_with_cap(double cap_rad) {
    scene::Scene scene;
    scene.materials = {matt(glm::vec3(0), glm::vec3(1)), matt(glm::vec3(0))};
    constexpr uint32_t kAround = 96, kDown = 24;
    for (uint32_t part = 0; part < 2; ++part) {
        scene::Mesh mesh;
        const double from = part == 0 ? 0 : cap_rad, to = part == 0 ? cap_rad : std::numbers::pi;
        for (uint32_t i = 0; i <= kDown; ++i)
            for (uint32_t j = 0; j <= kAround; ++j) {
                const double polar = from + (to - from) * i / kDown,
                             turn = 2 * std::numbers::pi * j / kAround;
                const glm::vec3 out(std::sin(polar) * std::cos(turn), std::cos(polar),
                                    std::sin(polar) * std::sin(turn));
                mesh.positions.push_back(3.0f * out);
                mesh.normals.push_back(-out);
                mesh.tangents.emplace_back(1, 0, 0, 1);
                mesh.uvs.emplace_back(0, 0);
            }
        for (uint32_t i = 0; i < kDown; ++i)
            for (uint32_t j = 0; j < kAround; ++j) {
                const uint32_t a = i * (kAround + 1) + j, b = a + 1, c = a + kAround + 1, d = c + 1;
                for (const uint32_t index : {a, c, b, b, c, d}) mesh.indices.push_back(index);
            }
        mesh.bounds = {glm::vec3(-3), glm::vec3(3)};
        scene.meshes.push_back(mesh);
        scene.instances.push_back({"part", part, part, glm::mat4(1)});
    }
    scene.bounds = {glm::vec3(-3), glm::vec3(3)};
    return scene;
}

// The difference to the closed form comes from the texels on the edge of the cap: a face has 32² of them.
TEST_F(Relight, ACapOfASphereHasTheHarmonicsOfItsClosedForm) {
    for (const double degrees : {30.0, 60.0}) {
        const double cap = degrees * std::numbers::pi / 180, c = std::cos(cap),
                     s2 = std::sin(cap) * std::sin(cap);
        const auto session = begin(sphere_with_cap(cap), probe_at({0, 0, 0}), {});
        ASSERT_TRUE(session);
        const std::vector<ProbeLight> light = round(*session);
        ASSERT_EQ(light.size(), 1u);
        for (const dvec3& n : kDirections) {
            const double y = n.y, p2 = 1.5 * y * y - 0.5, pi = std::numbers::pi;
            const double wanted = pi / 2 * (1 - c) + pi / 2 * s2 * y + 5 * pi / 16 * c * s2 * p2;
            EXPECT_NEAR(light[0].irradiance(n).r, wanted, 0.01 * pi * s2) << degrees << "°, y = " << y;
        }
    }
}

// Without several reflections, the light comes from the sun with its shadow, and from the sky through the
// open side.
TEST_F(Relight, AProbeInABoxThatLightsItselfHasTheLightOfTheReference) {
    const auto session = begin(open_box(kAlbedo05), probe_at(glm::vec3(kBoxProbe)),
                               {.feedback = Feedback::self, .sky = 1, .block_px = 1});
    ASSERT_TRUE(session);
    for (int i = 1; i <= 4; ++i) {
        const std::vector<ProbeLight> light = round(*session);
        ASSERT_EQ(light.size(), 1u);
        const Harmonics wanted = self_lit_box(32, double{kAlbedo05}, i);
        for (size_t k = 0; k < kBoxNormals.size(); ++k) {
            const double found = light[0].irradiance(kBoxNormals[k]).g;
            // The shadow map moves the edge of the shadow by about one of its texels, 0.02 m.
            EXPECT_NEAR(found, irradiance_of(wanted, kBoxNormals[k]), 0.005)
                << "round " << i << ", normal " << k;
            // The published values: 1.5 % for 32² texels per face and the rounding of the albedo.
            EXPECT_NEAR(found, kBoxSelfLit[size_t(i - 1)][k], 0.015 * kBoxSelfLit[3][k]) << i << ", " << k;
        }
    }
}

// Returns a regular grid of probes. Probes that are inside of walls or behind them move or do not exist.
scene::Probes regular_volume(const scene::Scene& scene, const std::string& grid) {
    const std::string text = R"({ "version": 1, "volume": { )" + grid + " } }";
    const Result<scene::Probes> probes = scene::read_probes(
        "grid.probes.json", [&](const std::string&) { return std::optional(text); }, scene);
    EXPECT_TRUE(probes) << to_text(probes.errors());
    return probes ? *probes : scene::Probes{};
}

// A grid of probes for a room from (-2, 0, -1) to (2, 3, 4). The walls are inside of its cells.
scene::Probes probes_in_the_room() {
    scene::Probes probes;
    probes.volume.origin = {-2.5f, -0.5f, -1.5f};
    for (int z = 0; z < 7; ++z)
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 6; ++x) {
                const bool inside = x > 0 && x < 5 && y > 0 && y < 4 && z > 0 && z < 6;
                const scene::ProbeState state = inside ? scene::ProbeState::kept : scene::ProbeState::dropped;
                probes.volume.probes.push_back({{x, y, z}, 0, glm::vec3(0), state});
            }
    return probes;
}

// All probes of a volume in a closed room see the same radiance. The cells reach beyond the walls, and the
// probes there do not exist. The bright sky outside is no part of it, not even while the probes around a
// point have no light yet.
TEST_F(Relight, AVolumeInAClosedRoomGivesTheGeometricSeries) {
    const scene::Scene room = closed_room({-2, 0, -1}, {2, 3, 4}, matt(glm::vec3(kAlbedo05), glm::vec3(1)));
    const scene::Probes probes = probes_in_the_room();
    const auto session = begin(room, probes, {.feedback = Feedback::volume, .face_px = 16, .sky = 1000});
    ASSERT_TRUE(session);
    EXPECT_EQ(count_, 60u);
    // A round sees the light of the rounds before it in the same frame, so the light is at least that of the
    // series.
    const double limit = 1 / (1 - double{kAlbedo05});
    double least = 0;
    for (int k = 0; k < 6; ++k) {
        least = least * double{kAlbedo05} + 1;
        for (const ProbeLight& light : round(*session)) {
            const double radiance = light.irradiance({0, 1, 0}).g / std::numbers::pi;
            EXPECT_GT(radiance, least - 1e-3) << k << " bounces";
            EXPECT_LT(radiance, limit + 1e-3) << k << " bounces";
        }
    }
}

// In a white room with a small lamp, the light of later rounds decreases, also if the probes never rest. So
// the light stays finite: at most 100 times that of a round.
TEST_F(Relight, LightInAWhiteRoomStaysFinite) {
    scene::Scene room = closed_room({-2, 0, -1}, {2, 3, 4}, matt(glm::vec3(1)));
    room.materials.push_back(matt(glm::vec3(1), glm::vec3(100)));
    add_quad(room, {-1.6f, 2.9f, 3.4f}, {0.2f, 0, 0}, {0, 0, 0.2f}, 1);
    const scene::Probes probes = probes_in_the_room();
    const auto session = begin(room, probes, {.feedback = Feedback::volume, .face_px = 16});
    ASSERT_TRUE(session);
    double before = 0, growth = 0;
    for (int k = 0; k < 30; ++k) {
        frame_of(*session).sky = even_sky(static_cast<float>(k));  // So that the probes do not rest.
        double sum = 0;
        for (const ProbeLight& light : round(*session)) sum += light.coefficients[0].g;
        ASSERT_GT(sum, before);
        if (k >= 20) {
            EXPECT_LT(sum - before, 0.995 * growth) << k;
        }
        growth = sum - before;
        before = sum;
    }
}

// The volume of probes gives the light of all reflections, which the published values of radiosity and path
// tracing have, and which one probe that lights itself misses by up to 65 %.
TEST_F(Relight, AVolumeOfProbesInABoxHasTheLightOfAllReflections) {
    const scene::Scene box = open_box(kAlbedo05);
    const scene::Probes probes =
        regular_volume(box, R"("origin": [-6, 0, -5], "spacing": 2, "size": [7, 4, 6])");
    const auto session = begin(box, probes, {.feedback = Feedback::volume, .face_px = 16, .sky = 1});
    ASSERT_TRUE(session);
    uint32_t number = 0;
    for (const scene::Probe& probe : probes.volume.probes) {
        if (scene::position_of(probes.volume, probe) == glm::vec3(kBoxProbe)) break;
        number += probe.state == scene::ProbeState::dropped ? 0 : 1;
    }
    ASSERT_LT(number, count_);
    const std::vector<ProbeLight> light = rounds(*session, 6);
    ASSERT_EQ(light.size(), count_);
    for (size_t k = 0; k < kBoxNormals.size(); ++k) {
        const double found = light[number].irradiance(kBoxNormals[k]).g;
        EXPECT_NEAR(found / kBoxAllReflections[k], 1, 0.03) << "normal " << k;
        std::printf("%u probes, normal %zu: %.3f, all reflections %.3f\n", count_, k, found,
                    kBoxAllReflections[k]);
    }
}

}  // namespace
}  // namespace weft::test

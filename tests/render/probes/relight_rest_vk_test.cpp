// Tests when the rounds that light probes run: after a change of any light, six times, and never while only
// the camera or the exposure changes. Also tests which light of lamps reaches the probes.
#include "tests/render/probes/relight_fixture.h"

namespace weft::test {
namespace {

using glm::dvec3;

constexpr int kRoundsOfAChange = 6;

scene::Light lamp_at(const glm::vec3& position, float candela) {
    scene::Light light;
    light.position = position;
    light.intensity = candela;
    return light;
}

class RelightRest : public Relight {
 protected:
    // Counts the rounds until all probes rest.
    int rounds_until_rest(render::Session& session) {
        for (int i = 0; i < 20; ++i) {
            round(session);
            if (rounds_run() == 0) return i;
        }
        return -1;
    }
};

TEST_F(RelightRest, ProbesRestUntilALightChanges) {
    scene::Scene scene = open_box(kAlbedo05);
    scene.lights.push_back(lamp_at({3, 3, 2}, 20));
    const auto session =
        begin(scene, probe_at(glm::vec3(kBoxProbe)), {.feedback = Feedback::volume, .face_px = 16, .sky = 1});
    ASSERT_TRUE(session);
    render::FrameInput& frame = frame_of(*session);
    EXPECT_EQ(rounds_until_rest(*session), kRoundsOfAChange);
    frame.camera.transform[3] += glm::vec4(2, 1, -1, 0);
    frame.exposure_ev = 3;
    frame.time_s = 5;
    EXPECT_EQ(rounds_until_rest(*session), 0) << "the camera, the exposure and the time are no lights";

    frame.lights = scene.lights;
    EXPECT_EQ(rounds_until_rest(*session), 0) << "these are the same lights";
    frame.lights->back().intensity = 30;
    EXPECT_EQ(rounds_until_rest(*session), kRoundsOfAChange) << "the lamp";
    const double before = round(*session)[0].irradiance({0, 1, 0}).g;
    frame.lights->front().direction = -glm::normalize(glm::vec3(0.2f, 1, 1));
    EXPECT_EQ(rounds_until_rest(*session), kRoundsOfAChange) << "the sun";
    EXPECT_NE(round(*session)[0].irradiance({0, 1, 0}).g, before);
    frame.sky = even_sky(2);
    EXPECT_EQ(rounds_until_rest(*session), kRoundsOfAChange) << "the surroundings";
}

// An object that moves is not part of what the probes see. The program has moved it before, so it counts as
// one that moves.
TEST_F(RelightRest, ProbesRestWhileAnObjectMoves) {
    scene::Scene scene = open_box(kAlbedo05);
    const auto moved = static_cast<uint32_t>(scene.instances.size());
    scene.materials.push_back(matt(glm::vec3(0)));
    add_quad(scene, {0, 1, 1}, {0, 0, 1}, {1, 0, 0}, 1);
    moves_instances_ = true;
    const auto session = begin(scene, probe_at(glm::vec3(kBoxProbe)), {.face_px = 16, .sky = 1});
    ASSERT_TRUE(session);
    glm::mat4 transform = scene.instances[moved].transform;
    const auto move = [&](float by_m) {
        transform[3].x += by_m;
        frame_of(*session).transforms = {{moved, transform}};
        return round(*session);
    };
    const double before = round(*session)[0].irradiance({0, -1, 0}).g;
    const double after = move(30)[0].irradiance({0, -1, 0}).g;
    EXPECT_GT(std::abs(after - before), 0.1) << "the object leaves the objects that do not move";
    frame_of(*session).transforms.clear();
    EXPECT_EQ(rounds_until_rest(*session), kRoundsOfAChange - 1);
    for (const float by_m : {-30.0f, 1.0f, 40.0f}) {
        EXPECT_EQ(move(by_m)[0].irradiance({0, -1, 0}).g, after);
        EXPECT_EQ(rounds_run(), 0u) << by_m;
    }
}

// A room with a lamp, and the light that a probe in it sees.
const dvec3 kRoomLeast(-2, 0, -1), kRoomMost(2, 3, 4), kRoomProbe(0.5, 1, 1), kRoomLamp(-1, 2.2, 2);
constexpr double kRoomCandela = 100;

scene::Scene lit_room(const scene::Light& lamp) {
    scene::Scene room = closed_room(kRoomLeast, kRoomMost, matt(glm::vec3(kAlbedo08)));
    room.lights = {lamp};
    return room;
}

// `facing`: the lamp is a small area that faces this way; nullopt: it shines evenly in all directions.
Harmonics light_of_lamp(const std::optional<dvec3>& facing) {
    return project(32, [&](const dvec3& d) {
        dvec3 normal(0), at(0);
        double nearest_m = 1e30;
        for (int axis = 0; axis < 3; ++axis) {
            const double distance_m =
                ((d[axis] > 0 ? kRoomMost : kRoomLeast)[axis] - kRoomProbe[axis]) / d[axis];
            if (distance_m >= nearest_m) continue;
            nearest_m = distance_m;
            at = kRoomProbe + d * distance_m;
            normal = dvec3(0);
            normal[axis] = d[axis] > 0 ? -1 : 1;
        }
        const dvec3 to_lamp = glm::normalize(kRoomLamp - at);
        const double candela = kRoomCandela * (facing ? std::max(0.0, -glm::dot(*facing, to_lamp)) : 1);
        const double away_m = glm::distance(kRoomLamp, at);
        return double{kAlbedo08} / std::numbers::pi * candela * glm::dot(to_lamp, normal) / (away_m * away_m);
    });
}

const std::array<dvec3, 5> kRoomNormals{dvec3(1, 0, 0), dvec3(-1, 0, 0), dvec3(0, 1, 0), dvec3(0, -1, 0),
                                        dvec3(0, 0, 1)};

// A lamp in a room lights it; a lamp behind the wall does not.
TEST_F(RelightRest, ALampShinesOnlyWhereTheProbeSeesIt) {
    const auto session = begin(lit_room(lamp_at(kRoomLamp, kRoomCandela)), probe_at(kRoomProbe), {});
    ASSERT_TRUE(session);
    const std::vector<ProbeLight> light = round(*session);
    ASSERT_EQ(light.size(), 1u);
    const Harmonics wanted = light_of_lamp({});
    for (const dvec3& n : kRoomNormals)
        EXPECT_NEAR(light[0].irradiance(n).g / irradiance_of(wanted, n), 1, 1e-3);

    frame_of(*session).lights = {lamp_at({-2.4f, 2.2f, 2}, kRoomCandela)};
    EXPECT_EQ(round(*session)[0].irradiance({0, 1, 0}), dvec3(0)) << "the lamp is behind the wall";
}

// Small lamps with an area give the light of a point.
TEST_F(RelightRest, LampsWithAnAreaLightTheRoom) {
    constexpr float kSide_m = 0.02f;
    scene::Light capsule = lamp_at(kRoomLamp, 0), rectangle = capsule;
    capsule.type = scene::LightType::capsule;
    capsule.half_size_m = {1e-5f, kSide_m};
    capsule.intensity = static_cast<float>(kRoomCandela / (std::numbers::pi * kSide_m * kSide_m));
    rectangle.type = scene::LightType::rectangle;
    rectangle.direction = {0, -1, 0};
    rectangle.half_size_m = {kSide_m, kSide_m};
    rectangle.intensity = static_cast<float>(kRoomCandela / (4 * kSide_m * kSide_m));
    const auto session = begin(lit_room(capsule), probe_at(kRoomProbe), {});
    ASSERT_TRUE(session);
    for (const bool is_rectangle : {false, true}) {
        if (is_rectangle) frame_of(*session).lights = {rectangle};
        const Harmonics wanted = light_of_lamp(is_rectangle ? std::optional(dvec3(0, -1, 0)) : std::nullopt);
        const std::vector<ProbeLight> light = round(*session);
        ASSERT_EQ(light.size(), 1u);
        for (const dvec3& n : kRoomNormals)
            EXPECT_NEAR(light[0].irradiance(n).g, irradiance_of(wanted, n),
                        0.04 * irradiance_of(wanted, {0, -1, 0}))
                << (is_rectangle ? "rectangle" : "capsule");
    }
}

// The lamp is a small glowing box, and a light at its middle. The probe sees the box, but only the light
// counts.
TEST_F(RelightRest, ALampThatGlowsCountsOnce) {
    const glm::vec3 lamp(-0.8f, 2, 1.5f);
    scene::Scene room = closed_room({-2, 0, -1}, {2, 3, 4}, matt(glm::vec3(kAlbedo05)));
    room.lights = {lamp_at(lamp, 100)};
    std::array<double, 2> found{};
    for (const bool glows : {false, true}) {
        if (glows) {
            room.materials.push_back(matt(glm::vec3(0), glm::vec3(20'000)));
            for (int axis = 0; axis < 3; ++axis)
                for (const int side : {-1, 1}) {  // Seen from outside, unlike the walls of the room.
                    add_wall(room, lamp - 0.08f, lamp + 0.08f, axis, side, 1);
                    room.instances.back().transform[0] *= -1.0f;
                    room.instances.back().transform[2] *= -1.0f;
                }
        }
        const auto session = begin(room, probe_at({0.4f, 1.5f, 1.3f}), {});
        ASSERT_TRUE(session);
        found[glows ? 1 : 0] = round(*session)[0].irradiance({-1, 0, 0}).g;
    }
    // The black box hides a part of the wall behind it. Its own light is several times as bright as the room.
    EXPECT_NEAR(found[1] / found[0], 1, 0.03);
}

}  // namespace
}  // namespace weft::test

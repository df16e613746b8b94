// Tests the light of the probes in whole scenes: a dark room behind a thin wall, and the same room elsewhere
// on the grid, turned, and listed in another order.
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>
#include <numeric>
#include <random>
#include <regex>

#include "tests/render/probes/probe_fixture.h"
#include "tests/scene/probes/probe_scenes.h"
#include "weft/report/plan_dump.h"
#include "weft/scene/place_probes.h"

namespace weft::test {
namespace {

constexpr const char* kSurfacesGraph = WEFT_SOURCE_DIR "/tests/render/probes/surfaces.json";
constexpr float kSide_m = 8;
constexpr int kMeasured = 128;
constexpr float kLong = 3, kWide = 2;  // Length of each room along x; half their width along z.

// A court and a dark room of 3 m × 4 m on both sides of a wall of 10 cm. The room has a ceiling, the court
// has none. The wall lies in the plane x = 0, and the court is at x > 0.
scene::test::BoxScene court_and_dark_room() {
    scene::test::BoxScene boxes;
    constexpr float kWall = 0.1f, kHigh = 2.4f;
    boxes.add({-kLong - kWall, -kWall, -kWide - kWall}, {kLong + kWall, 0, kWide + kWall});
    boxes.add({-kWall / 2, 0, -kWide}, {kWall / 2, kHigh, kWide});
    for (const float side : {-1.0f, 1.0f}) {
        const float x = side * (kLong + kWall / 2), z = side * (kWide + kWall / 2);
        boxes.add({x - kWall / 2, 0, -kWide}, {x + kWall / 2, kHigh, kWide});
        boxes.add({-kLong - kWall, 0, z - kWall / 2}, {kLong + kWall, kHigh, z + kWall / 2});
    }
    boxes.add({-kLong - kWall, kHigh, -kWide - kWall}, {kWall / 2, kHigh + kWall, kWide + kWall});
    boxes.scene.materials[0].base_color = glm::vec4(0.7f, 0.7f, 0.7f, 1);
    return boxes;
}

glm::mat4 turned(float degrees) {
    return glm::rotate(glm::mat4(1), glm::radians(degrees), glm::vec3(0, 1, 0));
}

scene::Scene moved(scene::Scene scene, const glm::mat4& by) {
    for (scene::Instance& instance : scene.instances) instance.transform = by * instance.transform;
    for (scene::Light& light : scene.lights) light.direction = glm::mat3(by) * light.direction;
    return scene;
}

scene::Light afternoon_sun() {
    scene::Light sun;
    sun.type = scene::LightType::directional;
    sun.direction = glm::normalize(glm::vec3(-0.4f, -1, -0.3f));
    sun.intensity = 50'000;
    return sun;
}

class ProbeLeaks : public ProbeTest {
 protected:
    // Lights the probes of a scene for some rounds under an even sky. Returns the light on the floor.
    std::vector<glm::vec4> measure(const scene::Scene& scene, uint32_t most_probes, uint32_t rounds,
                                   const std::map<std::string, double>& params = {}) {
        scene::PlacementParams placement;
        placement.most_probes = most_probes;
        Result<scene::Probes> probes = scene::place_probes(scene, placement);
        EXPECT_TRUE(probes);
        if (!probes) return {};
        std::map<std::string, double> all{{"sceneSunShadowSize", 512}};
        all.insert(params.begin(), params.end());
        const std::unique_ptr<render::Session> session =
            start_with_probes(scene, *probes, kSurfacesGraph, {16, 16, 1}, {"measured"}, all);
        if (!session) return {};
        render::FrameInput& frame = frame_of(*session);
        frame = {.camera = scene::framing_camera(scene, 1)};
        frame.sky = render::SkyColors{glm::vec3(4000), glm::vec3(4000), glm::vec3(4000)};
        frame.turns["probeTurns"].resize(session->probe_count());
        std::iota(frame.turns["probeTurns"].begin(), frame.turns["probeTurns"].end(), 0u);
        for (uint32_t i = 0; i < rounds; ++i) {
            frame.sky->ground = glm::vec3(4000 + float(i % 2));  // A change, so that the probes do not rest.
            const Status drawn = draw_frame(*session);
            EXPECT_TRUE(drawn) << to_text(drawn.errors());
            if (!drawn) return {};
        }
        EXPECT_TRUE(session->finish());
        std::vector<glm::vec4> light;
        for (auto& [name, texels] : take_results(*session).images) light = std::move(texels);
        return light;
    }
};

// The places of the measured texels in the room before it was turned.
glm::vec3 place_of(int i, const glm::mat4& turn) {
    const glm::vec2 at = (glm::vec2(i % kMeasured, i / kMeasured) + 0.5f) / float(kMeasured) - 0.5f;
    return glm::vec3(glm::inverse(turn) * glm::vec4(at.x * kSide_m, 0, at.y * kSide_m, 1));
}

// Mean light on the floors of the court and of the dark room, and the share of the room's floor that gets
// more than 2 % of the light of the court. The floor ends 3 cm before the walls.
struct FloorLight {
    double court = 0, room = 0, bright_share = 0;
};

FloorLight on_the_floor(const std::vector<glm::vec4>& light, const glm::mat4& turn) {
    constexpr float kApart = 0.03f;
    std::vector<double> lit, dark;
    for (int i = 0; i < kMeasured * kMeasured; ++i) {
        const glm::vec3 place = place_of(i, turn);
        if (std::abs(place.z) > kWide - kApart || std::abs(place.x) > kLong - kApart) continue;
        if (std::abs(place.x) < 0.05f + kApart) continue;
        const glm::vec4 seen = light[static_cast<size_t>(i)];
        EXPECT_GT(seen.w, 0.999) << "the sky shines on the floor at " << place.x << ", " << place.z;
        (place.x < 0 ? dark : lit).push_back(seen.g);
    }
    const auto mean = [](const std::vector<double>& x) {
        return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
    };
    const double limit = 0.02 * mean(lit);
    const auto bright = std::ranges::count_if(dark, [&](double x) { return x > limit; });
    return {mean(lit), mean(dark), static_cast<double>(bright) / static_cast<double>(dark.size())};
}

// Behind a wall of 10 cm, the floor gets less than 2 % of the light of the court, wherever the wall is on the
// grid of the probes. Where no probe near a place sees it, it may get more.
TEST_F(ProbeLeaks, AWallOfTenCentimetresKeepsTheLightOut) {
    const bool extended = std::getenv("WEFT_EXTENDED") != nullptr;
    std::vector<float> angles{0, 30, 46};
    if (extended) angles.insert(angles.end(), {0, 10, 30, 45, 60, 75, 86});
    std::mt19937 random(8);
    std::uniform_real_distribution<float> way_m(-0.5f, 0.5f);
    for (size_t i = 0; i < angles.size(); ++i) {
        const glm::mat4 turn = turned(angles[i]);
        const glm::vec3 way = i < 2 ? glm::vec3(0) : glm::vec3(way_m(random), 0, way_m(random));
        scene::Scene scene = court_and_dark_room().scene;
        scene.lights = {afternoon_sun()};
        const std::vector<glm::vec4> light =
            measure(moved(std::move(scene), glm::translate(glm::mat4(1), way) * turn), 200, extended ? 50 : 4,
                    {{"middleX", way.x}, {"middleZ", way.z}});
        ASSERT_EQ(light.size(), size_t{kMeasured} * kMeasured);
        const FloorLight floor = on_the_floor(light, turn);
        std::printf(
            "turned by %.0f°, moved by %.2f m, %.2f m: the court has %.0f, the room %.3f %% of it; "
            "%.2f %% of its floor have more than 2 %%\n",
            double{angles[i]}, double{way.x}, double{way.z}, floor.court, 100 * floor.room / floor.court,
            100 * floor.bright_share);
        EXPECT_GT(floor.court, 1000);
        EXPECT_LT(floor.room, 0.001 * floor.court);
        EXPECT_LE(floor.bright_share, 0.005);
    }
}

// Looks up the light at a place of the scene before it was turned, in a picture of the turned scene.
double light_at(const std::vector<glm::vec4>& light, const glm::vec3& place, const glm::mat4& turn) {
    const glm::vec3 at = glm::vec3(turn * glm::vec4(place, 1));
    const glm::ivec2 texel((glm::vec2(at.x, at.z) / kSide_m + 0.5f) * float(kMeasured));
    return light[static_cast<size_t>(texel.y * kMeasured + texel.x)].g;
}

// Returns the mean difference of the light on the floor of the court, as a share of the mean light. `turn` is
// that of the second scene.
double difference(const std::vector<glm::vec4>& one, const std::vector<glm::vec4>& other,
                  const glm::mat4& turn = glm::mat4(1)) {
    double sum = 0, apart = 0;
    for (float x = 0.2f; x < kLong - 0.2f; x += 0.1f)
        for (float z = 0.2f - kWide; z < kWide - 0.2f; z += 0.1f) {
            const double a = light_at(one, {x, 0, z}, glm::mat4(1)), b = light_at(other, {x, 0, z}, turn);
            sum += a;
            apart += std::abs(a - b);
        }
    return apart / sum;
}

// The light hardly depends on where the scene stands on the grid, on the directions of its walls, and on the
// order of its meshes.
TEST_F(ProbeLeaks, TheLightIsThatOfTheSceneAndNotOfTheGrid) {
    scene::Scene scene = court_and_dark_room().scene;
    scene.lights = {afternoon_sun()};
    const std::vector<glm::vec4> light = measure(scene, 200, 4);
    ASSERT_EQ(light.size(), size_t{kMeasured} * kMeasured);
    // Half a spacing of the finest level of this scene.
    const glm::vec3 way(0.5f, 0, 0.5f);
    const std::vector<glm::vec4> shifted = measure(moved(scene, glm::translate(glm::mat4(1), way)), 200, 4,
                                                   {{"middleX", way.x}, {"middleZ", way.z}});
    const double shift = difference(light, shifted);
    EXPECT_LT(shift, 0.15);
    const glm::mat4 turn = turned(37);
    const double turning = difference(light, measure(moved(scene, turn), 200, 4), turn);
    EXPECT_LT(turning, 0.08);
    const double order = difference(light, measure(scene::test::shuffled(scene, 3), 200, 4));
    EXPECT_LT(order, 1e-3);
    std::printf("difference after a shift %.4f, after a turn %.4f, in another order %.6f\n", shift, turning,
                order);
}

// Everything is white and the sky has the radiance 1, so each pixel is 1. A second light of the same kind
// would show.
TEST_F(ProbeLeaks, AWhiteCourtUnderAnEvenSkyIsEven) {
    scene::Scene scene = scene::test::open_court().scene;
    scene.materials[0].base_color = glm::vec4(1);
    scene::PlacementParams placement;
    placement.most_probes = 120;
    Result<scene::Probes> probes = scene::place_probes(scene, placement);
    ASSERT_TRUE(probes);
    const std::unique_ptr<render::Session> session =
        start_with_probes(scene, *probes, graph_path("deferred"), {96, 54, 1}, {"hdr"},
                          {{"probeFaceSize", 16}, {"autoExposure", 0}});
    ASSERT_TRUE(session);
    render::FrameInput& frame = frame_of(*session);
    frame = {.camera = scene::framing_camera(scene, 96.0f / 54)};
    frame.camera.transform =
        glm::inverse(glm::lookAt(glm::vec3(4, 2.4f, 4), glm::vec3(-3, 1, -3), glm::vec3(0, 1, 0)));
    frame.camera.fov_y_rad = 1.2f;
    frame.sky = render::SkyColors{glm::vec3(1), glm::vec3(1), glm::vec3(1)};
    ASSERT_TRUE(session->warm_up_probes(frame, {.rounds = 8}));
    ASSERT_TRUE(draw_frame(*session));
    ASSERT_TRUE(session->finish());
    const std::vector<glm::vec4> hdr = take_results(*session).images.at("hdr");
    ASSERT_EQ(hdr.size(), 96u * 54);
    double least = 1e9, most = 0, sum = 0;
    int dark = 0;
    for (const glm::vec4& texel : hdr) {
        const double value = double{texel.g} / double{session->pre_exposure()};
        least = std::min(least, value);
        most = std::max(most, value);
        sum += value;
        dark += value < 0.97 ? 1 : 0;
    }
    std::printf("mean %.4f, least %.4f, most %.4f; %d pixels below 0.97\n", sum / double(hdr.size()), least,
                most, dark);
    // In the corner behind the block, light has been reflected more often than there were rounds.
    EXPECT_GT(least, 0.94);
    EXPECT_LT(dark, 0.01 * double(hdr.size()));
    EXPECT_GT(sum / double(hdr.size()), 0.985);
    EXPECT_LT(most, 1.005);
}

// Without probes, the plan is that of a graph without the module.
TEST_F(ProbeLeaks, WithoutProbesThePlanIsThatWithoutTheModule) {
    const std::regex port(R"re((,\s*)?"(probe|reflection)\w+": \{ "ref": "\w+", "optional": true \})re");
    const auto without = [&](const std::string& path) {
        std::optional<std::string> text = read_text(path);
        if (!text) return text;
        const std::string include = "\"modules/probe_apply.json\", ";
        if (const size_t at = text->find(include); at != std::string::npos) text->erase(at, include.size());
        return std::optional(std::regex_replace(*text, port, ""));
    };
    for (const char* graph : {"deferred", "forward"}) {
        const Result<scene::Scene> scene = scene::make_builtin("cornell");
        const auto plan_of = [&](const FileReader& reader) {
            const std::unique_ptr<render::Session> session =
                start(*scene, scene->cameras.at(0), graph_path(graph), {64, 36, 1}, {}, 0, reader);
            // The parameters and the groups of the module are listed, and the hash depends on them.
            static const std::regex listed(
                "(hash|param  (probe|reflection|sceneSun)|group  (probe|reflection))[^\\n]*\\n");
            return session ? std::regex_replace(plan_to_text(session->plan()), listed, "") : std::string();
        };
        const std::string plan = plan_of(read_text);
        EXPECT_FALSE(plan.empty());
        EXPECT_EQ(plan, plan_of(without)) << graph;
    }
}

}  // namespace
}  // namespace weft::test

// Purpose: adds the atrium's lanterns, lights, sky and cameras.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/builtin/builtin_atrium_parts.h"
#include "scene/model/angles.h"

namespace weft::scene::atrium {
namespace {

constexpr float kLanternY = 3.05f;  // Height of the middle of the lantern's glass, in metres.
// Distance from the arcade's centre line to a lantern in the walkway, in metres. The lantern is near enough
// to the outer wall to light the wall. The four lanterns in the corners have other places.
constexpr float kLanternAcross = 2.35f;
// 110 cd in all directions are 1,400 lm, the light of a bright household lamp. The spots have the reflectors
// of small garden spots.
constexpr float kLantern_cd = 110, kSpot_cd = 45;

// Makes the iron frame of a lantern: a cage for six panes, a pointed hood, and a chain up to the ceiling.
Mesh lantern_frame() {
    MeshBuilder builder;
    constexpr float kHalf = 0.17f;
    const LatheShape six{6, 0, 2 * kPi, 0.5f, 0.5f};
    builder.add_lathe({{0, -kHalf - 0.05f}, {0.135f, -kHalf}, {0.1f, -kHalf + 0.012f}}, six);
    builder.add_lathe(
        {{0.12f, kHalf - 0.012f}, {0.178f, kHalf}, {0.06f, kHalf + 0.11f}, {0.012f, kHalf + 0.2f}}, six);
    for (int i = 0; i < 6; ++i) {
        const float turn = static_cast<float>(i) * kPi / 3;
        const glm::vec3 out{std::sin(turn), 0, std::cos(turn)};
        builder.add_tube({out * 0.117f + glm::vec3(0, -kHalf, 0), out * 0.142f + glm::vec3(0, kHalf, 0)},
                         {0.01f, 0.01f, 3});
    }
    builder.add_tube({{0, kHalf + 0.2f, 0}, {0, kCeiling - kLanternY, 0}}, {0.008f, 0.008f, 3});
    return builder.finish("lantern_frame");
}

// Makes the six panes of a lantern. Each pane shows the whole glow texture once.
Mesh lantern_glass() {
    MeshBuilder builder;
    constexpr float kHalf = 0.16f;
    for (int i = 0; i < 6; ++i) {
        const float left = static_cast<float>(i) * kPi / 3;
        const float right = left + kPi / 3;
        const auto corner = [](float turn, float radius, float y) {
            return glm::vec3(std::sin(turn) * radius, y, std::cos(turn) * radius);
        };
        builder.add_grid(2, 2, [&](uint32_t col, uint32_t row) {
            return GridPoint{
                corner(col == 0 ? left : right, row == 0 ? 0.108f : 0.132f, row == 0 ? -kHalf : kHalf),
                {static_cast<float>(col), 1 - static_cast<float>(row)}};
        });
    }
    return builder.finish("lantern_glass");
}

std::vector<glm::vec3> lantern_places() {
    std::vector<glm::vec3> places;
    for (const float sign : {-1.0f, 1.0f}) {
        for (int i = -3; i < 3; ++i)
            places.push_back(
                {sign * (kCourtHalfX + kLanternAcross), kLanternY, (static_cast<float>(i) + 0.5f) * kBay});
        for (int i = -2; i < 2; ++i)
            places.push_back(
                {(static_cast<float>(i) + 0.5f) * kBay, kLanternY, sign * (kCourtHalfZ + kLanternAcross)});
        for (const float end : {-1.0f, 1.0f})
            places.push_back({sign * (kCourtHalfX + 0.5f * kWalkDepth), kLanternY,
                              end * (kCourtHalfZ + 0.5f * kWalkDepth)});
    }
    return places;
}

void add_spot(Parts& parts, const char* name, glm::vec3 from, glm::vec3 to, float outer_rad) {
    Light light;
    light.name = name;
    light.type = LightType::spot;
    light.color = glm::vec3(1, 0.72f, 0.42f);
    light.intensity = kSpot_cd;
    light.position = from;
    light.direction = glm::normalize(to - from);
    light.range_m = 14;
    light.inner_cone_rad = outer_rad * 0.6f;
    light.outer_cone_rad = outer_rad;
    parts.scene.lights.push_back(light);
}

void add_camera(Parts& parts, const char* name, glm::vec3 eye, glm::vec3 at, float horizontal_fov_rad) {
    const glm::vec3 back = glm::normalize(eye - at);
    const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), back));
    Camera camera;
    camera.name = name;
    camera.transform = glm::mat4(glm::vec4(right, 0), glm::vec4(glm::cross(back, right), 0),
                                 glm::vec4(back, 0), glm::vec4(eye, 1));
    camera.fov_y_rad = 2 * std::atan(std::tan(0.5f * horizontal_fov_rad) * 9 / 16);
    parts.scene.cameras.push_back(camera);
}

}  // namespace

void add_lanterns(Parts& parts) {
    const uint32_t frame = add_mesh(parts, lantern_frame());
    const uint32_t glass = add_mesh(parts, lantern_glass());
    for (const glm::vec3& at : lantern_places()) {
        place_copy(parts, frame, parts.materials.iron, moved(at));
        place_copy(parts, glass, parts.materials.glass, moved(at));
    }
}

void add_lights(Parts& parts) {
    Scene& scene = parts.scene;
    const Daylight& day = parts.daylight;
    Light sun;
    sun.name = day.lamps < 1 ? "sun" : "moon";
    sun.type = LightType::directional;
    sun.color = day.color;
    sun.intensity = day.illuminance_lx;
    sun.direction = -day.to_source;
    scene.lights.push_back(sun);
    for (const glm::vec3& at : lantern_places()) {
        Light light;
        light.name = "lantern_" + std::to_string(scene.lights.size());
        light.type = LightType::point;
        light.color = glm::vec3(1, 0.62f, 0.28f);
        light.intensity = kLantern_cd;
        light.position = at;
        light.range_m = 7;
        scene.lights.push_back(light);
    }
    add_spot(parts, "spot_bougainvillea", {-3.2f, 0.3f, -6.4f}, {-5.4f, 3.2f, -8.8f}, 0.6f);
    add_spot(parts, "spot_armillary", {2.5f, 4.55f, -8.6f}, {0, 1.6f, -6.3f}, 0.35f);
    add_spot(parts, "spot_banner_left", {-3.4f, 0.2f, 0.6f}, {-5.4f, 4.6f, 0}, 0.5f);
    add_spot(parts, "spot_banner_right", {3.4f, 0.2f, -0.6f}, {5.4f, 4.6f, 0}, 0.5f);
    scene.sky_zenith = day.sky_zenith;
    scene.sky_horizon = day.sky_horizon;
    scene.exposure_ev = day.exposure_ev;
}

void add_cameras(Parts& parts) {
    add_camera(parts, "court", {3.9f, 1.75f, 8.1f}, {-1.5f, 2.6f, -3.2f}, 1.08f);
    add_camera(parts, "gallery", {-7.55f, 1.62f, 7.55f}, {-7.3f, 1.95f, -4.0f}, 1.12f);
    add_camera(parts, "pool", {-2.3f, 0.95f, 5.6f}, {2.6f, 1.7f, -2.6f}, 1.05f);
}

}  // namespace weft::scene::atrium

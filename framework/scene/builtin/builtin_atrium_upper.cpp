// Purpose: adds the upper storey of the atrium: galleries under tiled roofs on the long sides, terraces on
// the short sides.
#include <cmath>

#include "scene/builtin/builtin_atrium_parts.h"
#include "scene/model/angles.h"

namespace weft::scene::atrium {
namespace {

constexpr float kParapetTop = 5.98f;
constexpr float kLintelLow = 7.32f;
constexpr float kLintelHigh = 7.56f;
constexpr float kBackWallX = 8.5f;
// Distance from the middle of the gallery to the closed room at each of its ends, in metres.
constexpr float kEndZ = kCourtHalfZ - kWallHalf;
constexpr float kRoofEndZ = kCourtHalfZ + kWalkDepth + 0.35f;

// Adds the gallery's parapet. The functions in this file build one side of the court in local coordinates:
// the court lies towards +z, x runs along the side, and z = 0 is the centre line of the arcade.
void add_parapet(Parts& parts, const std::vector<glm::mat4>& sides) {
    const Materials& m = parts.materials;
    const std::vector<glm::vec3> path{{-kEndZ, 0, 0}, {kEndZ, 0, 0}};
    MeshBuilder trim;
    trim.add_sweep({{0.2f, kUpperFloor},
                    {0.2f, kUpperFloor + 0.14f},
                    {0.16f, kUpperFloor + 0.18f},
                    {0.12f, kUpperFloor + 0.18f}},
                   path, false);
    trim.add_sweep({{0.12f, kParapetTop - 0.14f},
                    {0.17f, kParapetTop - 0.1f},
                    {0.22f, kParapetTop - 0.09f},
                    {0.22f, kParapetTop - 0.01f},
                    {0.2f, kParapetTop},
                    {-0.18f, kParapetTop},
                    {-0.18f, kParapetTop - 0.1f}},
                   path, false);
    // Adds the piers between the panels of the parapet. The posts of the gallery stand on the piers.
    for (int i = -5; i <= 5; ++i) {
        const float x = static_cast<float>(i) * 1.5f;
        trim.add_box({x - 0.16f, kUpperFloor + 0.1f, 0.02f}, {x + 0.16f, kParapetTop - 0.08f, 0.17f});
    }
    MeshBuilder panel;
    panel.set_uv_offset({0, -kUpperFloor});
    panel.add_sweep({{0.12f, kUpperFloor + 0.17f}, {0.12f, kParapetTop - 0.13f}}, path, false);
    const uint32_t trim_mesh = add_mesh(parts, trim.finish("gallery_parapet_trim"));
    const uint32_t panel_mesh = add_mesh(parts, panel.finish("gallery_parapet"));
    for (const glm::mat4& side : sides) {
        place_copy(parts, trim_mesh, m.coping, side);
        place_copy(parts, panel_mesh, m.plaster_ochre, side);
    }
}

void add_posts(Parts& parts, const std::vector<glm::mat4>& sides) {
    const Materials& m = parts.materials;
    MeshBuilder builder;

    builder.add_lathe({{0.13f, 0}, {0.122f, 0.07f}, {0.088f, 0.14f}, {0.078f, 1.14f}, {0.13f, 1.27f}},
                      {8, 0, 2 * kPi, 1.5f, 1.5f});
    builder.add_box({-0.15f, 1.27f, -0.15f}, {0.15f, kLintelLow - kParapetTop, 0.15f});
    const uint32_t post = add_mesh(parts, builder.finish("gallery_post"));
    builder.add_box({-0.42f, kLintelLow, -0.07f}, {0.42f, kLintelLow + 0.12f, 0.07f});
    const uint32_t bracket = add_mesh(parts, builder.finish("gallery_bracket"));
    for (const glm::mat4& side : sides) {
        for (int i = -5; i <= 5; ++i) {
            const float x = static_cast<float>(i) * 1.5f;
            place_copy(parts, post, m.trim, side * moved({x, kParapetTop, 0}));
            place_copy(parts, bracket, m.beam, side * moved({x, 0, 0}));
        }
    }
}

float roof_height(float z) {
    return 8.95f - (z + 3.2f) * 0.36f;
}

// Makes a roof of half-round tiles side by side. u runs along the lower edge of the roof.
Mesh tiled_roof() {
    constexpr uint32_t kStepsPerTile = 3;
    constexpr float kTile = 0.25f;
    constexpr float kLowZ = 0.95f;
    const auto tiles = static_cast<uint32_t>(2 * kRoofEndZ / kTile);
    MeshBuilder builder;
    builder.add_grid(tiles * kStepsPerTile + 1, 2, [&](uint32_t i, uint32_t j) {
        const float x = -kRoofEndZ + static_cast<float>(i) * kTile / kStepsPerTile;
        const float z = j == 0 ? kLowZ : -3.4f;
        const float round = std::abs(std::sin(kPi * static_cast<float>(i) / kStepsPerTile));
        const float slope_m = (kLowZ - z) * 1.063f;
        return GridPoint{{x, roof_height(z) + 0.09f * round, z}, {x, -slope_m}};
    });
    return builder.finish("tiled_roof");
}

void add_roof(Parts& parts, const std::vector<glm::mat4>& sides) {
    const Materials& m = parts.materials;
    MeshBuilder wood;
    wood.add_bevelled_box({-kRoofEndZ, kLintelLow + 0.12f, -0.1f}, {kRoofEndZ, kLintelHigh + 0.12f, 0.1f},
                          0.015f);
    wood.add_bevelled_box({-kRoofEndZ, roof_height(0.93f) - 0.12f, 0.88f},
                          {kRoofEndZ, roof_height(0.93f) - 0.005f, 0.93f}, 0.01f);
    wood.add_rectangle({-kRoofEndZ, roof_height(-3.4f) - 0.01f, -3.4f}, {2 * kRoofEndZ, 0, 0},
                       {0, roof_height(0.95f) - roof_height(-3.4f), 4.35f});
    const uint32_t wood_mesh = add_mesh(parts, wood.finish("roof_timber"));
    // A rafter of the roof is built along x and then rotated to the slope of the roof.
    add_beam(wood, {-0.85f, -0.06f, -0.05f}, {0.6f, 0.06f, 0.05f});
    const uint32_t rafter = add_mesh(parts, wood.finish("rafter"));
    const uint32_t tiles = add_mesh(parts, tiled_roof());
    const float tilt = std::atan(0.36f);
    const glm::mat4 slope(glm::vec4(0, std::sin(tilt), -std::cos(tilt), 0),
                          glm::vec4(0, std::cos(tilt), std::sin(tilt), 0), glm::vec4(1, 0, 0, 0),
                          glm::vec4(0, roof_height(0) - 0.07f, 0, 1));
    for (const glm::mat4& side : sides) {
        place_copy(parts, wood_mesh, m.beam, side);
        place_copy(parts, tiles, m.roof, side);
        for (int i = -12; i <= 12; ++i) {
            place_copy(parts, rafter, m.beam, side * moved({static_cast<float>(i), 0, 0}) * slope);
        }
    }
}

// Adds the walls behind the gallery and around the closed rooms at its ends, with shuttered doors and
// windows.
void add_upper_walls(Parts& parts, const std::vector<glm::mat4>& sides) {
    const Materials& m = parts.materials;
    constexpr float kFront = kWallHalf;
    constexpr float kTop = 7.7f;
    MeshBuilder wall;
    wall.add_rectangle({-kEndZ, kUpperFloor, -(kBackWallX - kCourtHalfX)}, {2 * kEndZ, 0, 0}, {0, 3.2f, 0});
    for (const float sign : {-1.0f, 1.0f}) {
        const float near = sign * kEndZ;
        const float far = sign * (kRoofEndZ - 0.3f);
        wall.add_rectangle({std::min(near, far), kUpperFloor, kFront}, {std::abs(far - near), 0, 0},
                           {0, kTop - kUpperFloor, 0});
        const glm::vec3 origin =
            sign > 0 ? glm::vec3(near, kUpperFloor, -3.2f) : glm::vec3(near, kUpperFloor, kFront);
        wall.add_rectangle(origin, {0, 0, sign * (3.2f + kFront)}, {0, 3.6f, 0});
    }
    MeshBuilder shutters;
    for (int i = -3; i <= 3; ++i) {
        const float x = static_cast<float>(i) * 2.6f;
        const float z = -(kBackWallX - kCourtHalfX);
        shutters.add_box({x - 0.52f, kUpperFloor, z}, {x - 0.01f, kUpperFloor + 2.7f, z + 0.06f});
        shutters.add_box({x + 0.01f, kUpperFloor, z}, {x + 0.52f, kUpperFloor + 2.7f, z + 0.06f});
    }
    for (const float sign : {-1.0f, 1.0f}) {
        const float x = sign * (kEndZ + 1.75f);
        shutters.add_box({x - 0.47f, 5.75f, kFront}, {x - 0.01f, 7.05f, kFront + 0.05f});
        shutters.add_box({x + 0.01f, 5.75f, kFront}, {x + 0.47f, 7.05f, kFront + 0.05f});
    }
    const uint32_t wall_mesh = add_mesh(parts, wall.finish("upper_walls"));
    const uint32_t shutter_mesh = add_mesh(parts, shutters.finish("shutters"));
    for (const glm::mat4& side : sides) {
        place_copy(parts, wall_mesh, m.plaster_ochre, side);
        place_copy(parts, shutter_mesh, m.door, side);
    }
}

// Makes the floor of a terrace, and the plinth, the handrail and the pedestals of its balustrade.
Mesh terrace_rails() {
    constexpr float kHalf = kCourtHalfX - kWallHalf;
    const std::vector<glm::vec3> path{{-kHalf, 0, 0}, {kHalf, 0, 0}};
    MeshBuilder builder;
    builder.add_sweep({{0.17f, kUpperFloor},
                       {0.17f, kUpperFloor + 0.12f},
                       {0.13f, kUpperFloor + 0.15f},
                       {-0.13f, kUpperFloor + 0.15f},
                       {-0.17f, kUpperFloor + 0.12f},
                       {-0.17f, kUpperFloor}},
                      path, false);
    builder.add_sweep({{-0.13f, 5.78f},
                       {0.13f, 5.78f},
                       {0.17f, 5.81f},
                       {0.17f, 5.88f},
                       {0.14f, 5.91f},
                       {-0.14f, 5.91f},
                       {-0.17f, 5.88f},
                       {-0.17f, 5.81f},
                       {-0.13f, 5.78f}},
                      path, false);
    for (int i = -1; i <= 1; ++i) {
        const float x = static_cast<float>(i) * kBay;
        builder.add_box({x - 0.21f, kUpperFloor, -0.21f}, {x + 0.21f, 5.88f, 0.21f});
        builder.add_bevelled_box({x - 0.25f, 5.88f, -0.25f}, {x + 0.25f, 5.98f, 0.25f}, 0.02f);
    }
    builder.add_rectangle({-kHalf, kUpperFloor - 0.01f, 0.3f}, {2 * kHalf, 0, 0}, {0, 0, -kWalkDepth - 0.4f});
    return builder.finish("terrace_rails");
}

}  // namespace

void add_upper_gallery(Parts& parts) {
    std::vector<glm::mat4> sides;
    for (const float turn : {0.5f * kPi, -0.5f * kPi}) {
        sides.push_back(moved({0, 0, 0}, turn) * moved({0, 0, -kCourtHalfX}));
    }
    add_parapet(parts, sides);
    add_posts(parts, sides);
    add_roof(parts, sides);
    add_upper_walls(parts, sides);
}

void add_terraces(Parts& parts) {
    const Materials& m = parts.materials;
    const uint32_t rails = add_mesh(parts, terrace_rails());
    MeshBuilder builder;
    builder.add_lathe({{0.05f, 0}, {0.082f, 0.2f}, {0.036f, 0.46f}, {0.066f, 0.63f}},
                      {6, 0, 2 * kPi, 1.5f, 1.5f});
    const uint32_t baluster = add_mesh(parts, builder.finish("baluster"));
    for (const float half_turn : {0.0f, kPi}) {
        const glm::mat4 side = moved({0, 0, 0}, half_turn) * moved({0, 0, -kCourtHalfZ});
        place_copy(parts, rails, m.coping, side);
        for (int i = 0; i < 21; ++i) {
            const float x = -5.5f + static_cast<float>(i) * 0.55f;
            const float to_post = std::abs(x - kBay * std::round(x / kBay));
            if (to_post < 0.27f && std::abs(x) < 4) continue;
            place_copy(parts, baluster, m.trim, side * moved({x, kUpperFloor + 0.15f, 0}));
        }
    }
}

}  // namespace weft::scene::atrium

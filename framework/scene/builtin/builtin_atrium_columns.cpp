// Purpose: adds the arcade's columns. Each has a round base on a square plate, a shaft that is thinner at the
// top, and a capital with leaves.
#include <cmath>

#include "scene/builtin/builtin_atrium_parts.h"
#include "scene/model/angles.h"

namespace weft::scene::atrium {
namespace {

constexpr uint32_t kSegments = 16;
constexpr float kShaftLow = 0.34f;  // Height of the shaft's lower end above the floor, in metres.
constexpr float kShaftHigh = 2.42f;
constexpr float kCapitalHigh = kSpring - kFloor - 0.12f;

Profile base_profile() {
    return {{0.35f, 0.12f},  {0.37f, 0.165f}, {0.3f, 0.23f},
            {0.328f, 0.29f}, {0.29f, 0.322f}, {0.267f, kShaftLow}};
}

// Adds one leaf of the capital. The leaf rises along the bell-shaped body and curls outwards at its tip.
void add_capital_leaf(MeshBuilder& builder, float angle, float low, float high, float width) {
    constexpr uint32_t kCols = 3;
    constexpr uint32_t kRows = 3;
    const glm::vec3 outward{std::sin(angle), 0, std::cos(angle)};
    const glm::vec3 side{outward.z, 0, -outward.x};
    builder.add_grid(kCols, kRows, [&](uint32_t i, uint32_t j) {
        const float t = static_cast<float>(j) / (kRows - 1);
        const float across = static_cast<float>(i) / (kCols - 1) * 2 - 1;
        const float half =
            width * 0.5f * (0.75f + 0.5f * std::sin(kPi * (0.15f + 0.75f * t))) * (1 - 0.55f * t * t * t);
        const float curl = t * t * t;
        const float radius = 0.262f + 0.035f * t + 0.05f * curl - 0.014f * across * across;
        const float y = low + (high - low) * (t < 0.8f ? t / 0.8f : 1 - (t - 0.8f) * 0.4f);
        return GridPoint{outward * radius + side * (across * half) + glm::vec3(0, y, 0), {across * half, -y}};
    });
}

Mesh base_and_capital() {
    MeshBuilder builder;
    const LatheShape shape{kSegments, 0, 2 * kPi, 1.5f, 1.5f};
    builder.add_box({-0.37f, 0, -0.37f}, {0.37f, 0.12f, 0.37f});
    builder.add_lathe(base_profile(), shape);
    builder.add_lathe({{0.232f, kShaftHigh - 0.03f},
                       {0.26f, kShaftHigh - 0.005f},
                       {0.24f, kShaftHigh + 0.015f},
                       {0.262f, 2.64f},
                       {0.335f, kCapitalHigh}},
                      shape);
    builder.add_box({-0.345f, kCapitalHigh, -0.345f}, {0.345f, kCapitalHigh + 0.05f, 0.345f});
    builder.add_box({-0.375f, kCapitalHigh + 0.05f, -0.375f}, {0.375f, kCapitalHigh + 0.12f, 0.375f});
    for (int i = 0; i < 8; ++i) {
        add_capital_leaf(builder, kPi * 0.25f * static_cast<float>(i), kShaftHigh + 0.02f, 2.71f, 0.155f);
    }

    return builder.finish("column_base_and_capital");
}

Mesh shaft() {
    MeshBuilder builder;
    Profile profile;
    for (int i = 0; i <= 2; ++i) {
        const float t = static_cast<float>(i) / 2;
        const float entasis = 0.006f * std::sin(kPi * t);
        profile.push_back(
            {0.265f - 0.032f * t * t + entasis, kShaftLow + (kShaftHigh - 0.02f - kShaftLow) * t});
    }
    builder.add_lathe(profile, {kSegments, 0, 2 * kPi, 1, 2});
    return builder.finish("column_shaft");
}

}  // namespace

void add_columns(Parts& parts) {
    const uint32_t stone = add_mesh(parts, base_and_capital());
    const uint32_t marble = add_mesh(parts, shaft());
    std::vector<glm::vec2> places;
    for (const float sign : {-1.0f, 1.0f}) {
        for (int i = -2; i <= 2; ++i) places.push_back({sign * kCourtHalfX, static_cast<float>(i) * kBay});
        for (int i = -1; i <= 1; ++i) places.push_back({static_cast<float>(i) * kBay, sign * kCourtHalfZ});
    }
    float turn = 0;
    for (const glm::vec2& at : places) {
        place_copy(parts, stone, parts.materials.trim, moved({at.x, kFloor, at.y}, turn));
        place_copy(parts, marble, parts.materials.marble, moved({at.x, kFloor, at.y}, 1.7f * turn));
        parts.footprints.push_back({at, {0.37f, 0.37f}, false, 0.45f, 0.75f});
        turn += 0.5f * kPi;
    }
}

}  // namespace weft::scene::atrium

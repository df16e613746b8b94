// Purpose: adds the pool in the middle of the court, and the fountain in the pool.
#include <algorithm>
#include <array>
#include <cmath>

#include "scene/builtin/builtin_atrium_parts.h"
#include "scene/model/angles.h"

namespace weft::scene::atrium {
namespace {

constexpr float kRimWidth = 0.36f;
constexpr float kPoolFloor = 0.04f;
constexpr float kWaterLevel = kPoolFloor + kWaterDepth;
constexpr float kPadRadius = 0.2f;

// Distributes floating leaves in two groups with little overlap. Returns x, z and the radius of each leaf.
std::vector<glm::vec3> scatter_pads(Random& random) {
    std::vector<glm::vec3> pads;
    for (int attempt = 0; attempt < 400 && pads.size() < 12; ++attempt) {
        const glm::vec2 home = pads.size() % 3 == 0 ? glm::vec2(-0.8f, -2.7f) : glm::vec2(0.55f, 2.35f);
        const float angle = random.range(0, 2 * kPi);
        const float reach = std::sqrt(random.unit());
        const float radius = random.range(0.11f, 0.23f);
        const glm::vec3 pad{home.x + 0.5f * reach * std::cos(angle), home.y + 0.95f * reach * std::sin(angle),
                            radius};
        const bool free = std::none_of(pads.begin(), pads.end(), [&](const glm::vec3& other) {
            return glm::length(glm::vec2(other) - glm::vec2(pad)) < 0.9f * (other.z + radius);
        });
        if (free) pads.push_back(pad);
    }
    return pads;
}

// Adds a floating leaf: a shallow dish with a raised rim. The alpha mask of the texture cuts out the round
// outline and the notch of the leaf.
void add_pad(MeshBuilder& builder) {
    constexpr uint32_t kSides = 10;
    constexpr std::array<glm::vec2, 3> kProfile{{{0.015f, 0}, {0.145f, 0.002f}, {kPadRadius, 0.02f}}};
    builder.add_grid(kSides + 1, kProfile.size(), [&](uint32_t col, uint32_t row) {
        const float turn = static_cast<float>(col) / kSides * 2 * kPi;
        const glm::vec2 out = kProfile[row].x * glm::vec2(std::cos(turn), std::sin(turn));
        return GridPoint{{out.x, kProfile[row].y, out.y}, 0.5f + out / (2 * kPadRadius)};
    });
}

void add_lilies(Parts& parts) {
    MeshBuilder builder;
    add_pad(builder);
    const uint32_t mesh = add_mesh(parts, builder.finish("lily_pad"));
    Random random(77);
    const std::vector<glm::vec3> pads = scatter_pads(random);
    for (size_t i = 0; i < pads.size(); ++i) {
        const float lift = 0.004f + 0.001f * static_cast<float>(i % 3);
        const glm::vec3 at{pads[i].x, kWaterLevel + lift, pads[i].y};
        place_copy(parts, mesh, parts.materials.lily, moved(at, random.range(0, 6), pads[i].z / kPadRadius));
    }
}

// Makes the stone parts of the fountain, from the floor of the pool upwards: a foot, a stem and two bowls.
Mesh fountain_stone() {
    MeshBuilder builder;
    builder.add_lathe({{0.36f, kPoolFloor},
                       {0.36f, 0.42f},
                       {0.34f, 0.44f},
                       {0.27f, 0.45f},
                       {0.2f, 0.5f},
                       {0.12f, 0.6f},
                       {0.11f, 0.72f},
                       {0.17f, 0.87f},
                       {0.14f, 0.94f}},
                      {18, 0, 2 * kPi, 1.5f, 1.5f});
    builder.add_lathe({{0.12f, 0.93f},
                       {0.3f, 0.96f},
                       {0.52f, 1.05f},
                       {0.68f, 1.18f},
                       {0.72f, 1.22f},
                       {0.74f, 1.25f},
                       {0.73f, 1.28f},
                       {0.69f, 1.28f},
                       {0.66f, 1.24f}},
                      {26, 0, 2 * kPi, 1.5f, 3});
    builder.add_lathe({{0.14f, 1.2f},
                       {0.065f, 1.36f},
                       {0.055f, 1.52f},
                       {0.08f, 1.57f},
                       {0.2f, 1.62f},
                       {0.31f, 1.69f},
                       {0.34f, 1.74f},
                       {0.33f, 1.76f},
                       {0.31f, 1.76f},
                       {0.29f, 1.73f}},
                      {20, 0, 2 * kPi, 1.5f, 1.5f});
    return builder.finish("fountain");
}

}  // namespace

void add_pool(Parts& parts) {
    const Materials& m = parts.materials;
    const float x = kPoolHalfX;
    const float z = kPoolHalfZ;
    // The outside of the pool is on the right-hand side of this path, because a swept profile is offset to
    // the right.
    const std::vector<glm::vec3> loop{{x, 0, z}, {x, 0, -z}, {-x, 0, -z}, {-x, 0, z}};
    MeshBuilder builder;
    builder.add_sweep({{0.07f, 0}, {0.07f, 0.06f}, {0.05f, 0.08f}, {0.01f, 0.08f}}, loop, true);
    builder.add_sweep({{0.01f, kPoolRim - 0.09f},
                       {0.05f, kPoolRim - 0.075f},
                       {0.06f, kPoolRim - 0.05f},
                       {0.06f, kPoolRim - 0.02f},
                       {0.04f, kPoolRim},
                       {-kRimWidth, kPoolRim},
                       {-kRimWidth - 0.02f, kPoolRim - 0.02f},
                       {-kRimWidth - 0.02f, kPoolRim - 0.07f},
                       {-kRimWidth, kPoolRim - 0.08f}},
                      loop, true);
    place(parts, builder.finish("pool_rim"), m.coping);
    builder.add_sweep({{0.01f, 0.08f}, {0.01f, kPoolRim - 0.09f}}, loop, true);
    builder.add_sweep({{-kRimWidth, kPoolRim - 0.08f}, {-kRimWidth, kPoolFloor}}, loop, true);
    builder.add_rectangle({kRimWidth - x, kPoolFloor, z - kRimWidth}, {2 * (x - kRimWidth), 0, 0},
                          {0, 0, -2 * (z - kRimWidth)});
    place(parts, builder.finish("pool_tiles"), m.zellige);
    const glm::vec2 half{x - kRimWidth, z - kRimWidth};
    builder.add_rectangle({-half.x, kWaterLevel, half.y}, {2 * half.x, 0, 0}, {0, 0, -2 * half.y});
    place(parts, builder.finish("pool_water"), m.water);
    parts.footprints.push_back({{0, 0}, {x, z}, false, 0.6f, 0.7f});
    add_lilies(parts);
}

void add_fountain(Parts& parts) {
    const Materials& m = parts.materials;
    MeshBuilder builder;
    place(parts, fountain_stone(), m.trim);
    builder.add_lathe({{0.68f, 1.25f}, {0.1f, 1.25f}}, {26, 0, 2 * kPi, 2, 4});
    builder.add_lathe({{0.3f, 1.735f}, {0.03f, 1.735f}}, {20, 0, 2 * kPi, 2, 2});
    place(parts, builder.finish("fountain_water"), m.water);
    builder.add_lathe({{0.07f, 1.72f}, {0.035f, 1.79f}, {0.035f, 1.84f}, {0.06f, 1.865f}, {0.04f, 1.885f}},
                      {12, 0, 2 * kPi, 1, 1});
    builder.add_sphere({0, 2.0f, 0}, 0.135f, 20, 12);
    place(parts, builder.finish("fountain_finial"), m.gold);
}

}  // namespace weft::scene::atrium

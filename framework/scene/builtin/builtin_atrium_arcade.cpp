// Purpose: adds the arcade around the atrium's court: arches, the wall above the arches, medallions above the
// columns, the cornice and the corner piers.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/builtin/builtin_atrium_parts.h"
#include "scene/model/angles.h"

namespace weft::scene::atrium {
namespace {

constexpr uint32_t kArchSegments = 14;
constexpr float kPierHalf = 0.36f;

// Returns the matrix that turns a lathe shape (axis upwards) into an arch: the axis runs from front to back,
// and angle 0 is the top of the arch.
glm::mat4 arch_frame(glm::vec3 center) {
    return glm::translate(glm::mat4(1), center) * glm::rotate(glm::mat4(1), -0.5f * kPi, glm::vec3(1, 0, 0));
}

// Adds the ring of wedge stones around an arch. The ring protrudes from the wall on both sides.
void add_arch_ring(MeshBuilder& builder, glm::vec3 center) {
    constexpr float kFront = -kWallHalf - 0.05f;
    constexpr float kBack = kWallHalf + 0.03f;
    constexpr float kChamfer = 0.02f;
    LatheShape shape;
    shape.segments = kArchSegments;
    shape.from_rad = -0.5f * kPi;
    shape.to_rad = 0.5f * kPi;
    // Length of the texture around the arch in metres. The arch has fifteen wedge stones, and four stones of
    // the texture are 1.1 m long together.
    shape.u_span_m = 15 * 1.1f / 4;
    builder.set_transform(arch_frame(center));
    builder.set_uv_offset({0.1375f, 0});
    builder.add_lathe({{kArchOuter, kWallHalf},
                       {kArchRadius, kBack},
                       {kArchRadius, kFront + kChamfer},
                       {kArchRadius + kChamfer, kFront},
                       {kArchOuter, kFront},
                       {kArchOuter, -kWallHalf}},
                      shape);
    builder.set_transform(glm::mat4(1));
    builder.set_uv_offset({0, 0});
}

// Adds one side of the wall above an arch. The area is a rectangle as wide as one bay (the distance between
// two columns), without the ring of stones and the opening of the arch.
void add_spandrel(MeshBuilder& builder, float center_x, float z, float facing) {
    const float height = kWallTop - kSpring;
    const float half = 0.5f * kBay;
    const float corner = std::atan2(height, half);
    std::vector<float> angles;
    for (uint32_t i = 0; i <= kArchSegments; ++i) {
        angles.push_back(kPi * static_cast<float>(i) / static_cast<float>(kArchSegments));
    }
    angles.insert(angles.end(), {corner, kPi - corner});
    std::sort(angles.begin(), angles.end());
    std::vector<glm::vec3> inner;
    std::vector<glm::vec3> outer;
    for (const float angle : angles) {
        const glm::vec2 d{std::cos(angle), std::sin(angle)};
        const float reach =
            std::min(d.y > 1e-4f ? height / d.y : 1e9f, std::abs(d.x) > 1e-4f ? half / std::abs(d.x) : 1e9f);
        const float ring = kArchOuter - 0.01f;
        inner.push_back({center_x + d.x * ring, kSpring + d.y * ring, z});
        outer.push_back({center_x + d.x * reach, kSpring + d.y * reach, z});
    }
    if (facing > 0) {  // The points must run from left to right, seen from the front of the wall.
        std::reverse(inner.begin(), inner.end());
        std::reverse(outer.begin(), outer.end());
    }
    builder.add_strip(inner, outer, {facing, 0, 0}, {0, 1, 0});
}

// Adds a round ornament of tiles above each column.
void add_medallions(Parts& parts, int bays, const glm::mat4& to_world, uint32_t rim, uint32_t disc) {
    for (int i = 1; i < bays; ++i) {
        const float x = (static_cast<float>(i) - 0.5f * static_cast<float>(bays)) * kBay;
        const glm::mat4 at = to_world * glm::translate(glm::mat4(1), {x, 3.98f, kWallHalf}) *
                             glm::rotate(glm::mat4(1), 0.5f * kPi, glm::vec3(1, 0, 0));
        place_copy(parts, rim, parts.materials.trim, at);
        place_copy(parts, disc, parts.materials.zellige, at);
    }
}

void add_side(Parts& parts, int bays, float distance, float turn_rad) {
    const Materials& m = parts.materials;
    MeshBuilder front;
    MeshBuilder back;
    MeshBuilder rings;
    for (int i = 0; i < bays; ++i) {
        const float x = (static_cast<float>(i) + 0.5f - 0.5f * static_cast<float>(bays)) * kBay;
        add_arch_ring(rings, {x, kSpring, 0});
        add_spandrel(front, x, kWallHalf, 1);
        add_spandrel(back, x, -kWallHalf, -1);
    }
    const uint32_t front_mesh = add_mesh(parts, front.finish("arcade_front"));
    const uint32_t back_mesh = add_mesh(parts, back.finish("arcade_back"));
    const uint32_t ring_mesh = add_mesh(parts, rings.finish("arch_rings"));
    for (const float half_turn : {0.0f, kPi}) {
        const glm::mat4 to_world = moved({0, 0, 0}, turn_rad + half_turn) * moved({0, 0, -distance});
        place_copy(parts, front_mesh, m.ashlar, to_world);
        place_copy(parts, back_mesh, m.trim_shaded, to_world);
        place_copy(parts, ring_mesh, m.voussoir, to_world);
    }
}

std::vector<glm::vec3> inward_loop(float half_x, float half_z, float y) {
    return {{-half_x, y, half_z}, {-half_x, y, -half_z}, {half_x, y, -half_z}, {half_x, y, half_z}};
}

// Adds the cornice: a band of stone between the lower and the upper storey.
void add_cornice(Parts& parts) {
    MeshBuilder builder;
    builder.add_sweep({{0, -0.06f},
                       {0.04f, -0.06f},
                       {0.04f, 0.04f},
                       {0.07f, 0.07f},
                       {0.07f, 0.16f},
                       {0.1f, 0.18f},
                       {0.15f, 0.22f},
                       {0.2f, 0.29f},
                       {0.23f, 0.3f},
                       {0.23f, 0.37f},
                       {0.2f, 0.38f},
                       {-0.3f, 0.38f}},
                      inward_loop(kCourtHalfX - kWallHalf, kCourtHalfZ - kWallHalf, kWallTop), true);
    place(parts, builder.finish("cornice"), parts.materials.coping);
}

void add_pier(Parts& parts, float x, float z) {
    const Materials& m = parts.materials;
    MeshBuilder stone;
    stone.set_transform(moved({x, 0, z}));
    stone.add_bevelled_box({-kPierHalf, kFloor + 0.3f, -kPierHalf}, {kPierHalf, kSpring - 0.14f, kPierHalf},
                           0.02f);
    stone.add_box({-0.35f, kSpring, -0.35f}, {0.35f, kWallTop + 0.02f, 0.35f});
    place(parts, stone.finish("corner_pier"), m.ashlar);
    MeshBuilder trim;
    trim.set_transform(moved({x, 0, z}));
    trim.add_box({-0.43f, kFloor, -0.43f}, {0.43f, kFloor + 0.2f, 0.43f});
    trim.add_bevelled_box({-0.4f, kFloor + 0.2f, -0.4f}, {0.4f, kFloor + 0.31f, 0.4f}, 0.03f);
    trim.add_box({-0.39f, kSpring - 0.15f, -0.39f}, {0.39f, kSpring - 0.08f, 0.39f});
    trim.add_bevelled_box({-0.43f, kSpring - 0.08f, -0.43f}, {0.43f, kSpring, 0.43f}, 0.02f);
    place(parts, trim.finish("corner_pier_trim"), m.trim);
    parts.footprints.push_back({{x, z}, {0.43f, 0.43f}, false, 0.45f, 0.75f});
}

}  // namespace

void add_arcades(Parts& parts) {
    add_side(parts, 4, kCourtHalfZ, 0);
    add_side(parts, 6, kCourtHalfX, 0.5f * kPi);
    MeshBuilder builder;
    builder.add_lathe({{0.27f, 0}, {0.25f, 0.05f}, {0.2f, 0.03f}}, {12, 0, 2 * kPi, 1.5f, 1.5f});
    const uint32_t rim = add_mesh(parts, builder.finish("medallion_rim"));
    builder.add_lathe({{0.21f, 0.02f}, {0, 0.035f}}, {12, 0, 2 * kPi, 0.6f, 1.2f});
    const uint32_t disc = add_mesh(parts, builder.finish("medallion"));
    for (const float half_turn : {0.0f, kPi}) {
        add_medallions(parts, 4, moved({0, 0, 0}, half_turn) * moved({0, 0, -kCourtHalfZ}), rim, disc);
        add_medallions(parts, 6, moved({0, 0, 0}, half_turn + 0.5f * kPi) * moved({0, 0, -kCourtHalfX}), rim,
                       disc);
    }
    add_cornice(parts);
    for (const float x : {-kCourtHalfX, kCourtHalfX}) {
        for (const float z : {-kCourtHalfZ, kCourtHalfZ}) add_pier(parts, x, z);
    }
}

}  // namespace weft::scene::atrium

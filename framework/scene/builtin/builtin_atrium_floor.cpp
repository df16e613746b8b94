// Purpose: adds the atrium's ground floor: court, walkway, outer walls and ceiling.
#include <array>

#include "scene/builtin/builtin_atrium_parts.h"

namespace weft::scene::atrium {
namespace {

constexpr float kOuterX = kCourtHalfX + kWalkDepth;
constexpr float kOuterZ = kCourtHalfZ + kWalkDepth;
constexpr float kStepX = kCourtHalfX - 0.5f;
constexpr float kStepZ = kCourtHalfZ - 0.5f;
constexpr float kStepBevel = 0.025f;
constexpr float kDadoLow = kFloor + 0.1f;
constexpr float kDadoHigh = kDadoLow + 1.2f;

// Returns a closed path around the court. The court is on the right-hand side of the direction of travel,
// because a swept profile is offset to the right.
std::vector<glm::vec3> inward_floor_loop(float half_x, float half_z) {
    return {{-half_x, 0, half_z}, {-half_x, 0, -half_z}, {half_x, 0, -half_z}, {half_x, 0, half_z}};
}

// Adds the horizontal area between two rectangles around the court. `inner` and `outer` are half of their
// sides along x and z. `up` is +1 for a floor and -1 for a ceiling.
void add_frame(MeshBuilder& builder, glm::vec2 inner, glm::vec2 outer, float y, float up) {
    const glm::vec2 depth = outer - inner;
    const std::array<glm::vec4, 4> pieces{{{-outer.x, -outer.y, depth.x, 2 * outer.y},
                                           {inner.x, -outer.y, depth.x, 2 * outer.y},
                                           {-inner.x, -outer.y, 2 * inner.x, depth.y},
                                           {-inner.x, inner.y, 2 * inner.x, depth.y}}};
    for (const glm::vec4& piece : pieces) {
        const float z = up > 0 ? piece.y + piece.w : piece.y;
        builder.add_rectangle({piece.x, y, z}, {piece.z, 0, 0}, {0, 0, -up * piece.w});
    }
}

// Adds a floor border between two rectangles, with mitred corners. The texture's u runs along the border, v
// from the outer edge inwards.
void add_border(MeshBuilder& builder, glm::vec2 inner, glm::vec2 outer, float y) {
    for (uint32_t side = 0; side < 4; ++side) {
        const bool along_x = side & 1U;
        const float sign = side & 2U ? 1.0f : -1.0f;
        const glm::vec3 up = along_x ? glm::vec3(0, 0, sign) : glm::vec3(sign, 0, 0);
        const glm::vec3 right = glm::cross(up, glm::vec3(0, 1, 0));
        const float in = along_x ? inner.y : inner.x;
        const float out = along_x ? outer.y : outer.x;
        const float half_in = along_x ? inner.x : inner.y;
        const float half_out = along_x ? outer.x : outer.y;
        const glm::vec3 level{0, y, 0};
        builder.set_uv_offset({0, out});
        builder.add_strip({up * in - right * half_in + level, up * in + right * half_in + level},
                          {up * out - right * half_out + level, up * out + right * half_out + level}, right,
                          up);
    }
    builder.set_uv_offset({0, 0});
}

void add_floors(Parts& parts) {
    const Materials& m = parts.materials;
    MeshBuilder builder;
    builder.add_rectangle({-kStepX, 0, kStepZ}, {2 * kStepX, 0, 0}, {0, 0, -2 * kStepZ});
    place(parts, builder.finish("court_floor"), m.flags);

    const glm::vec2 court{kCourtHalfX, kCourtHalfZ};
    add_frame(builder, court - 0.5f + kStepBevel, court + 0.5f, kFloor, 1);
    add_frame(builder, court + 3.0f, {kOuterX, kOuterZ}, kFloor, 1);
    place(parts, builder.finish("stylobate"), m.trim_floor);

    add_border(builder, court + 0.5f, court + 1.0f, kFloor);
    place(parts, builder.finish("inlaid_border"), m.inlay);

    add_frame(builder, court + 1.0f, court + 3.0f, kFloor, 1);
    place(parts, builder.finish("checker_floor"), m.checker);

    builder.add_sweep({{0, 0}, {0, kFloor - kStepBevel}, {-kStepBevel, kFloor}},
                      inward_floor_loop(kStepX, kStepZ), true);
    place(parts, builder.finish("step"), m.coping);
}

void add_outer_walls(Parts& parts) {
    const Materials& m = parts.materials;
    const std::vector<glm::vec3> loop = inward_floor_loop(kOuterX, kOuterZ);
    MeshBuilder builder;
    builder.add_sweep({{0.05f, kFloor}, {0.05f, kDadoLow - 0.02f}, {0.03f, kDadoLow}, {0.02f, kDadoLow}},
                      loop, true);
    builder.add_sweep({{0.02f, kDadoHigh},
                       {0.05f, kDadoHigh + 0.01f},
                       {0.065f, kDadoHigh + 0.035f},
                       {0.065f, kDadoHigh + 0.06f},
                       {0.04f, kDadoHigh + 0.08f},
                       {0, kDadoHigh + 0.1f}},
                      loop, true);
    builder.add_sweep({{0, 4.12f}, {0.05f, 4.14f}, {0.05f, 4.2f}, {0.1f, 4.28f}, {0.1f, 4.32f}, {0, 4.32f}},
                      loop, true);
    place(parts, builder.finish("wall_mouldings"), m.trim_shaded);

    builder.set_uv_offset({0, -kDadoLow});
    builder.add_sweep({{0.02f, kDadoLow}, {0.02f, kDadoHigh}}, loop, true);
    place(parts, builder.finish("tile_dado"), m.azulejo);

    builder.set_uv_offset({0, -(kDadoHigh + 0.1f)});
    builder.add_sweep({{0, kDadoHigh + 0.1f}, {0, kCeiling}}, loop, true);
    place(parts, builder.finish("walkway_walls"), m.plaster_red);
}

// Adds the outside of the building: plain walls on a strip of earth.
void add_outside(Parts& parts) {
    constexpr float kThick = 0.3f;
    const std::vector<glm::vec3> inward = inward_floor_loop(kOuterX + kThick, kOuterZ + kThick);
    const std::vector<glm::vec3> outward(inward.rbegin(), inward.rend());
    MeshBuilder builder;
    builder.add_sweep({{0, -0.03f}, {0, kUpperFloor}, {-kThick, kUpperFloor}}, outward, true);
    place(parts, builder.finish("outside_walls"), parts.materials.ashlar);
    add_frame(builder, {kOuterX, kOuterZ}, {kOuterX + 1.2f, kOuterZ + 2.8f}, -0.03f, 1);
    place(parts, builder.finish("outside_ground"), parts.materials.soil);
}

// Adds the ceiling: boards on top of beams. Each beam is built along x, because the grain of the wood texture
// runs along x.
void add_ceiling(Parts& parts) {
    const Materials& m = parts.materials;
    MeshBuilder builder;
    add_frame(builder, {kCourtHalfX, kCourtHalfZ}, {kOuterX, kOuterZ}, kCeiling, -1);
    place(parts, builder.finish("ceiling_boards"), m.beam);

    const float half = 0.5f * (kWalkDepth - kWallHalf);
    add_beam(builder, {-half, 4.3f, -0.11f}, {half, kCeiling, 0.11f});
    const uint32_t beam = add_mesh(parts, builder.finish("ceiling_beam"));
    add_beam(builder, {-half, 4.43f, -0.05f}, {half, kCeiling, 0.05f});
    const uint32_t joist = add_mesh(parts, builder.finish("ceiling_joist"));
    const float middle = kWallHalf + half;
    for (const float sign : {-1.0f, 1.0f}) {
        for (int i = -9; i <= 9; ++i) {
            const glm::vec3 at{sign * (kCourtHalfX + middle), 0, static_cast<float>(i)};
            place_copy(parts, i % 3 == 0 ? beam : joist, m.beam, moved(at));
        }
        for (int i = -6; i <= 6; ++i) {
            const glm::vec3 at{static_cast<float>(i), 0, sign * (kCourtHalfZ + middle)};
            place_copy(parts, i % 3 == 0 ? beam : joist, m.beam, moved(at, 1.5707963f));
        }
    }
}

// Adds flat piers to the outer walls, opposite the columns of the arcade.
void add_pilasters(Parts& parts) {
    MeshBuilder builder;
    builder.add_box({-0.24f, kFloor, 0}, {0.24f, kFloor + 0.22f, 0.17f});
    builder.add_rectangle({-0.19f, kFloor + 0.22f, 0.12f}, {0.38f, 0, 0}, {0, 3.7f, 0});
    builder.add_rectangle({-0.19f, kFloor + 0.22f, 0}, {0, 0, 0.12f}, {0, 3.7f, 0});
    builder.add_rectangle({0.19f, kFloor + 0.22f, 0.12f}, {0, 0, -0.12f}, {0, 3.7f, 0});
    builder.add_box({-0.22f, 3.92f, 0}, {0.22f, 4.0f, 0.145f});
    builder.add_box({-0.26f, 4.0f, 0}, {0.26f, 4.12f, 0.18f});
    const uint32_t pilaster = add_mesh(parts, builder.finish("pilaster"));
    for (const float sign : {-1.0f, 1.0f}) {
        for (int i = -3; i <= 3; ++i) {
            place_copy(parts, pilaster, parts.materials.trim_shaded,
                       moved({sign * kOuterX, 0, static_cast<float>(i) * kBay}, -sign * 1.5707963f));
        }
        for (int i = -2; i <= 2; ++i) {
            place_copy(
                parts, pilaster, parts.materials.trim_shaded,
                moved({static_cast<float>(i) * kBay, 0, sign * kOuterZ}, sign > 0 ? 3.1415927f : 0.0f));
        }
    }
}

// Adds double doors in stone frames. The wood texture's boards run along x, but a door needs upright boards.
// So each half of a door is built lying along x and then rotated.
void add_doors(Parts& parts) {
    const Materials& m = parts.materials;
    MeshBuilder stone;
    for (const float x : {-0.86f, 0.68f}) stone.add_box({x, kFloor, 0}, {x + 0.18f, 2.72f, 0.13f});
    stone.add_box({-0.86f, 2.72f, 0}, {0.86f, 2.92f, 0.13f});
    stone.add_bevelled_box({-0.95f, 2.92f, 0}, {0.95f, 3.02f, 0.2f}, 0.015f);
    stone.add_box({-0.7f, kFloor, 0}, {0.7f, kFloor + 0.05f, 0.16f});
    const glm::mat4 upright(glm::vec4(0, 1, 0, 0), glm::vec4(-1, 0, 0, 0), glm::vec4(0, 0, 1, 0),
                            glm::vec4(0, 0, 0, 1));
    MeshBuilder wood;
    wood.set_transform(upright);
    wood.add_box({kFloor + 0.05f, -0.68f, 0.02f}, {2.72f, -0.008f, 0.07f});
    wood.add_box({kFloor + 0.05f, 0.008f, 0.02f}, {2.72f, 0.68f, 0.07f});
    MeshBuilder iron;
    for (const float y : {0.55f, 1.45f, 2.35f}) {
        for (const float x : {-0.66f, 0.06f}) iron.add_box({x, y, 0.07f}, {x + 0.6f, y + 0.06f, 0.08f});
    }
    for (const float x : {-0.1f, 0.1f}) iron.add_sphere({x, 1.25f, 0.09f}, 0.035f, 6, 4);
    const uint32_t frame = add_mesh(parts, stone.finish("door_frame"));
    const uint32_t leaves = add_mesh(parts, wood.finish("door_leaves"));
    const uint32_t straps = add_mesh(parts, iron.finish("door_straps"));
    for (const float sign : {-1.0f, 1.0f}) {
        for (const float z : {-7.5f, 1.5f}) {
            const glm::mat4 at = moved({sign * kOuterX, 0, sign * z}, -sign * 1.5707963f);
            place_copy(parts, frame, m.trim_shaded, at);
            place_copy(parts, leaves, m.door, at);
            place_copy(parts, straps, m.iron, at);
        }
    }
}

}  // namespace

void add_ground_floor(Parts& parts) {
    add_floors(parts);
    add_outer_walls(parts);
    add_outside(parts);

    add_pilasters(parts);
    add_doors(parts);
    add_ceiling(parts);
}

}  // namespace weft::scene::atrium

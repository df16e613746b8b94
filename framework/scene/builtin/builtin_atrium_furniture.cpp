// Purpose: adds the atrium's furniture: benches, crates, barrels and vases.
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/builtin/builtin_atrium_parts.h"
#include "scene/model/angles.h"

namespace weft::scene::atrium {
namespace {

constexpr float kWallX = kCourtHalfX + kWalkDepth;

void add_benches(Parts& parts) {
    MeshBuilder builder;
    builder.add_bevelled_box({-0.85f, 0.4f, -0.22f}, {0.85f, 0.48f, 0.22f}, 0.018f);
    for (const float x : {-0.58f, 0.58f}) {
        builder.add_box({x - 0.1f, 0, -0.17f}, {x + 0.1f, 0.06f, 0.17f});
        builder.add_box({x - 0.075f, 0.06f, -0.145f}, {x + 0.075f, 0.4f, 0.145f});
    }
    const uint32_t bench = add_mesh(parts, builder.finish("stone_bench"));
    for (const float sign : {-1.0f, 1.0f}) {
        for (const float z : sign > 0 ? std::array{7.5f, -1.5f} : std::array{1.5f, -7.5f}) {
            place_copy(parts, bench, parts.materials.trim_shaded,
                       moved({sign * (kWallX - 0.32f), kFloor, z}, sign * -0.5f * kPi));
            parts.footprints.push_back({{sign * (kWallX - 0.32f), z}, {0.18f, 0.8f}, false, 0.4f, 0.85f});
        }
    }
    place_copy(parts, bench, parts.materials.trim, moved({3.5f, 0, -0.7f}, 0.5f * kPi));
    parts.footprints.push_back({{3.5f, -0.7f}, {0.18f, 0.8f}, false, 0.45f, 0.85f});
}

// Makes a wooden crate: a box of boards with battens along all edges.
Mesh crate(float half) {
    MeshBuilder builder;
    builder.add_box({-half + 0.02f, 0.02f, -half + 0.02f}, {half - 0.02f, 2 * half - 0.02f, half - 0.02f});
    const float batten = 0.07f;
    for (const float y : {0.0f, 2 * half - batten}) {
        for (const float z : {-half, half - 0.03f})
            builder.add_box({-half, y, z}, {half, y + batten, z + 0.03f});
        for (const float x : {-half, half - 0.03f}) {
            builder.add_box({x, y, -half + 0.03f}, {x + 0.03f, y + batten, half - 0.03f});
        }
    }
    for (const float z : {-half, half - 0.03f}) {
        for (const float x : {-half, half - batten}) {
            builder.set_transform(glm::translate(glm::mat4(1), {x + 0.5f * batten, half, z + 0.015f}) *
                                  glm::rotate(glm::mat4(1), 0.5f * kPi, glm::vec3(0, 0, 1)));
            builder.add_box({-half + batten, -0.5f * batten, -0.015f},
                            {half - batten, 0.5f * batten, 0.015f});
            builder.set_transform(glm::mat4(1));
        }
    }
    return builder.finish("crate");
}

void add_crates(Parts& parts) {
    const Materials& m = parts.materials;
    const uint32_t big = add_mesh(parts, crate(0.32f));
    const uint32_t small = add_mesh(parts, crate(0.24f));
    const glm::vec3 corner{-kWallX + 0.55f, kFloor, -4.9f};
    place_copy(parts, big, m.planks, moved(corner, 0.12f));
    place_copy(parts, big, m.planks, moved(corner + glm::vec3(0.05f, 0, 0.78f), -0.2f));
    place_copy(parts, small, m.planks, moved(corner + glm::vec3(0.02f, 0.64f, 0.08f), 0.5f));
    place_copy(parts, small, m.planks, moved(corner + glm::vec3(0.74f, 0, 0.3f), 0.9f));
    parts.footprints.push_back({{corner.x, corner.z + 0.4f}, {0.34f, 0.72f}, false, 0.5f, 0.85f});
    parts.footprints.push_back({{corner.x + 0.74f, corner.z + 0.3f}, {0.3f, 0.3f}, true, 0.3f, 0.7f});
}

void add_barrels(Parts& parts) {
    const Materials& m = parts.materials;
    MeshBuilder wood;
    wood.add_lathe({{0.25f, 0},
                    {0.29f, 0.2f},
                    {0.31f, 0.42f},
                    {0.29f, 0.64f},
                    {0.25f, 0.84f},
                    {0.23f, 0.84f},
                    {0.23f, 0.8f},
                    {0, 0.8f}},
                   {16, 0, 2 * kPi, 1, 2});
    MeshBuilder hoops;
    for (const glm::vec2& hoop : {glm::vec2(0.265f, 0.06f), glm::vec2(0.296f, 0.22f),
                                  glm::vec2(0.296f, 0.58f), glm::vec2(0.265f, 0.74f)}) {
        hoops.add_lathe({{hoop.x + 0.005f, hoop.y}, {hoop.x + 0.005f, hoop.y + 0.04f}},
                        {16, 0, 2 * kPi, 0.5f, 0});
    }
    const uint32_t barrel = add_mesh(parts, wood.finish("barrel"));
    const uint32_t iron = add_mesh(parts, hoops.finish("barrel_hoops"));
    for (const glm::vec3& at :
         {glm::vec3(kWallX - 0.45f, kFloor, -4.0f), glm::vec3(kWallX - 0.5f, kFloor, -4.75f),
          glm::vec3(-kWallX + 0.45f, kFloor, -3.55f)}) {
        place_copy(parts, barrel, m.planks, moved(at, at.z));
        place_copy(parts, iron, m.iron, moved(at, at.z));
        parts.footprints.push_back({{at.x, at.z}, {0.26f, 0.26f}, true, 0.45f, 0.85f});
    }
}

Profile vase_profile() {
    return {{0.135f, 0.01f}, {0.095f, 0.06f},  {0.17f, 0.2f}, {0.232f, 0.38f},
            {0.225f, 0.5f},  {0.18f, 0.61f},   {0.1f, 0.71f}, {0.095f, 0.78f},
            {0.145f, 0.85f}, {0.125f, 0.855f}, {0.07f, 0.76f}};
}

void add_vases(Parts& parts) {
    const Materials& m = parts.materials;
    MeshBuilder builder;
    builder.add_lathe(vase_profile(), {16, 0, 2 * kPi, 1, 1});
    for (const float side : {-1.0f, 1.0f}) {
        builder.add_tube({{side * 0.1f, 0.77f, 0},
                          {side * 0.19f, 0.78f, 0},
                          {side * 0.25f, 0.7f, 0},
                          {side * 0.25f, 0.6f, 0},
                          {side * 0.205f, 0.54f, 0}},
                         {0.014f, 0.014f, 4});
    }
    const uint32_t vase = add_mesh(parts, builder.finish("bronze_vase"));
    builder.set_transform(glm::mat4(1));
    builder.add_bevelled_box({-0.27f, 0, -0.27f}, {0.27f, 0.1f, 0.27f}, 0.015f);
    builder.add_box({-0.22f, 0.1f, -0.22f}, {0.22f, 0.72f, 0.22f});
    builder.add_bevelled_box({-0.27f, 0.72f, -0.27f}, {0.27f, 0.8f, 0.27f}, 0.02f);
    const uint32_t pedestal = add_mesh(parts, builder.finish("pedestal"));
    for (const float sign : {-1.0f, 1.0f}) {
        {
            const glm::vec3 at{sign * 7.75f, kFloor, -(kCourtHalfZ + kWalkDepth - 0.5f)};
            place_copy(parts, pedestal, m.trim_shaded, moved(at));
            place_copy(parts, vase, m.bronze, moved(at + glm::vec3(0, 0.8f, 0), 0, 1.15f));
            parts.footprints.push_back({{at.x, at.z}, {0.27f, 0.27f}, false, 0.45f, 0.85f});
        }
        const glm::vec3 standing{sign * 2.35f, 0, -7.6f};
        place_copy(parts, vase, m.bronze, moved(standing, 0.4f * sign, 1.3f));
        parts.footprints.push_back({{standing.x, standing.z}, {0.16f, 0.16f}, true, 0.5f, 0.85f});
    }
}

}  // namespace

void add_furniture(Parts& parts) {
    add_benches(parts);
    add_crates(parts);
    add_barrels(parts);
    add_vases(parts);
}

}  // namespace weft::scene::atrium

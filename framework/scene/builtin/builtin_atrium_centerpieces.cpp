// Purpose: adds two groups of objects to the atrium: a table with dishes in the walkway, and an armillary
// sphere (steel rings around a gold ball) in the court.
#include <glm/gtc/matrix_transform.hpp>

#include "scene/builtin/builtin_atrium_parts.h"
#include "scene/model/angles.h"

namespace weft::scene::atrium {
namespace {

constexpr float kTableTop = 0.79f;

glm::mat4 at_point(glm::vec3 point) {
    return glm::translate(glm::mat4(1), point);
}

// Makes a wooden table. The grain of the texture runs along x. So the legs are built lying along x and then
// rotated upright: their grain runs along the legs.
Mesh table() {
    MeshBuilder wood;
    wood.add_bevelled_box({-0.8f, 0.74f, -0.36f}, {0.8f, kTableTop, 0.36f}, 0.01f);
    wood.add_box({-0.7f, 0.64f, -0.29f}, {0.7f, 0.74f, 0.29f});
    for (const float x : {-0.68f, 0.68f}) {
        for (const float z : {-0.27f, 0.27f}) {
            wood.set_transform(at_point({x, 0.33f, z}) *
                               glm::rotate(glm::mat4(1), 0.5f * kPi, glm::vec3(0, 0, 1)));
            wood.add_box({-0.33f, -0.04f, -0.04f}, {0.33f, 0.04f, 0.04f});
        }
    }
    return wood.finish("table");
}

// Makes the steel objects on the table: a bowl and a pitcher.
Mesh steel_ware() {
    MeshBuilder steel;
    steel.set_transform(at_point({-0.3f, kTableTop, 0.02f}));
    steel.add_lathe({{0.08f, 0},
                     {0.08f, 0.012f},
                     {0.06f, 0.02f},
                     {0.13f, 0.07f},
                     {0.19f, 0.14f},
                     {0.205f, 0.155f},
                     {0.2f, 0.16f},
                     {0.18f, 0.14f},
                     {0.12f, 0.075f},
                     {0, 0.05f}},
                    {18, 0, 2 * kPi, 0.5f, 1});
    steel.set_transform(at_point({0.42f, kTableTop, -0.05f}));
    steel.add_lathe({{0.09f, 0},
                     {0.1f, 0.015f},
                     {0.085f, 0.03f},
                     {0.115f, 0.1f},
                     {0.12f, 0.16f},
                     {0.1f, 0.22f},
                     {0.065f, 0.27f},
                     {0.06f, 0.31f},
                     {0.08f, 0.35f},
                     {0.07f, 0.35f},
                     {0.05f, 0.31f}},
                    {20, 0, 2 * kPi, 0.5f, 0.5f});
    steel.add_tube(
        {{0.07f, 0.32f, 0}, {0.14f, 0.32f, 0}, {0.17f, 0.25f, 0}, {0.15f, 0.16f, 0}, {0.115f, 0.13f, 0}},
        {0.01f, 0.01f, 6});
    return steel.finish("steel_ware");
}

Mesh gold_cup() {
    MeshBuilder gold;
    gold.set_transform(at_point({0.12f, kTableTop, 0.16f}));
    gold.add_lathe({{0.045f, 0},
                    {0.045f, 0.008f},
                    {0.012f, 0.02f},
                    {0.01f, 0.08f},
                    {0.04f, 0.1f},
                    {0.052f, 0.16f},
                    {0.048f, 0.16f},
                    {0.035f, 0.11f},
                    {0, 0.1f}},
                   {12, 0, 2 * kPi, 1, 1});
    return gold.finish("gold_cup");
}

Mesh armillary_stand() {
    MeshBuilder stone;
    stone.add_bevelled_box({-0.5f, 0, -0.5f}, {0.5f, 0.12f, 0.5f}, 0.02f);
    stone.add_lathe({{0.4f, 0.12f},
                     {0.43f, 0.15f},
                     {0.43f, 0.19f},
                     {0.36f, 0.22f},
                     {0.31f, 0.27f},
                     {0.29f, 0.34f},
                     {0.27f, 0.9f},
                     {0.3f, 0.94f},
                     {0.36f, 0.97f},
                     {0.38f, 1.0f},
                     {0.38f, 1.05f},
                     {0.3f, 1.08f},
                     {0, 1.08f}},
                    {22, 0, 2 * kPi, 1.5f, 1.5f});
    return stone.finish("armillary_stand");
}

// Makes the steel parts of the armillary sphere: a foot, two upright rings at right angles to each other, a
// tilted ring, and the vertical axis.
Mesh armillary_rings(glm::vec3 center) {
    const glm::mat4 middle = at_point(center);
    const glm::vec3 x{1, 0, 0};
    const glm::vec3 z{0, 0, 1};
    MeshBuilder rings;
    rings.set_transform(at_point({0, 1.08f, 0}));
    rings.add_lathe({{0.14f, 0}, {0.13f, 0.03f}, {0.05f, 0.06f}, {0.04f, 0.1f}, {0.06f, 0.14f}},
                    {16, 0, 2 * kPi, 0.5f, 0.5f});
    rings.set_transform(middle * glm::rotate(glm::mat4(1), 0.5f * kPi, x));
    rings.add_torus(0.56f, 0.022f, 36, 5);
    rings.set_transform(middle * glm::rotate(glm::mat4(1), 0.5f * kPi, z));
    rings.add_torus(0.515f, 0.018f, 30, 4);
    rings.set_transform(middle * glm::rotate(glm::mat4(1), 0.41f, z));
    rings.add_torus(0.47f, 0.024f, 30, 5);
    rings.add_tube({{0, -0.56f, 0}, {0, 0.56f, 0}}, {0.01f, 0.01f, 6});
    return rings.finish("armillary_rings");
}

}  // namespace

void add_table(Parts& parts) {
    const Materials& m = parts.materials;
    const glm::vec3 floor{-(kCourtHalfX + kWalkDepth) + 0.62f, kFloor, 4.5f};
    const glm::mat4 at = moved(floor, 0.5f * kPi);
    place_copy(parts, add_mesh(parts, table()), m.planks, at);
    place_copy(parts, add_mesh(parts, steel_ware()), m.steel, at);
    place_copy(parts, add_mesh(parts, gold_cup()), m.gold, at);
    MeshBuilder fruit;
    for (const glm::vec3& p : {glm::vec3(-0.36f, 0.895f, 0.02f), glm::vec3(-0.26f, 0.895f, 0.08f),
                               glm::vec3(-0.27f, 0.895f, -0.04f), glm::vec3(-0.3f, 0.955f, 0.02f)}) {
        fruit.add_sphere(p, 0.05f, 12, 7);
    }
    place_copy(parts, add_mesh(parts, fruit.finish("table_fruit")), m.orange, at);
    parts.footprints.push_back({{floor.x, floor.z}, {0.36f, 0.8f}, false, 0.3f, 0.5f});
}

void add_armillary(Parts& parts) {
    const Materials& m = parts.materials;
    const glm::vec3 at{0, 0, -6.3f};
    const glm::vec3 center{0, 1.78f, 0};
    place_copy(parts, add_mesh(parts, armillary_stand()), m.trim, moved(at));
    place_copy(parts, add_mesh(parts, armillary_rings(center)), m.steel, moved(at, 0.55f));
    MeshBuilder globe;
    globe.add_sphere(center, 0.19f, 24, 12);
    place_copy(parts, add_mesh(parts, globe.finish("gold_sphere")), m.gold, moved(at));
    parts.footprints.push_back({{at.x, at.z}, {0.5f, 0.5f}, false, 0.6f, 0.8f});
}

}  // namespace weft::scene::atrium

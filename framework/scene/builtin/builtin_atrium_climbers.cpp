// Purpose: adds the atrium's climbing plants: ivy on columns and parapets, bougainvillea over an arch.
#include <algorithm>
#include <cmath>
#include <functional>

#include "scene/builtin/builtin_atrium_leaves.h"
#include "scene/builtin/builtin_atrium_parts.h"
#include "scene/model/angles.h"

namespace weft::scene::atrium {

glm::vec3 on_sphere(Random& random) {
    const float y = random.range(-1, 1);
    const float turn = random.range(0, 6.2831853f);
    const float r = std::sqrt(std::max(0.0f, 1 - y * y));
    return {r * std::cos(turn), y, r * std::sin(turn)};
}

Card facing_card(glm::vec3 center, glm::vec3 facing, float roll_rad, float half_m) {
    const glm::vec3 front = glm::normalize(facing);
    const glm::vec3 axis = std::abs(front.y) < 0.95f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 right = glm::normalize(glm::cross(axis, front));
    const glm::vec3 up = glm::cross(front, right);
    Card card;
    card.center = center;
    card.right = (right * std::cos(roll_rad) + up * std::sin(roll_rad)) * half_m;
    card.up = (up * std::cos(roll_rad) - right * std::sin(roll_rad)) * half_m;
    return card;
}

namespace {

// A point on the surface that a plant climbs, with the surface's normal.
struct Hold {
    glm::vec3 position;
    glm::vec3 outward;
};
// A function that maps two numbers in 0..1 to a point on the surface that a plant climbs.
using Carrier = std::function<Hold(float, float)>;

Mesh climber(uint32_t count, float half_m, uint32_t seed, const Carrier& carrier) {
    Random random(seed);
    MeshBuilder builder;
    for (uint32_t i = 0; i < count; ++i) {
        const float a = random.unit();
        const float b = random.unit();
        const Hold hold = carrier(a, b);
        const glm::vec3 facing = hold.outward + on_sphere(random) * 0.4f + glm::vec3(0, 0.15f, 0);
        const float lift = random.range(0.03f, 0.11f);
        const float roll = random.range(-0.6f, 0.6f);
        const float half = half_m * random.range(0.75f, 1.2f);
        Card card = facing_card(hold.position + hold.outward * lift, facing, roll, half);
        card.soft_normals = true;
        card.normal_center = hold.position - hold.outward * 0.35f;
        builder.add_card(card);
    }
    return builder.finish("climber");
}

// Maps (a, b) to a point on a column, for a plant that winds around the column. `a` goes around the column,
// `b` goes from the foot (0) to the top (1). The plant is wide at the foot and narrow at the top.
Hold around_column(float a, float b) {
    const float y = kFloor + 0.1f + 2.75f * (0.4f * b * b + 0.6f * b);
    const float turn = a * 2 * kPi * (1 - 0.55f * b) + 4.0f * b;
    const glm::vec3 outward{std::sin(turn), 0, std::cos(turn)};
    return {outward * 0.255f + glm::vec3(0, y, 0), outward};
}

// Maps (a, b) to a point on ivy that hangs over the gallery's parapet. `a` goes along the parapet, `b` goes
// from the wide top (0) to the narrow bottom (1). The point is in the local coordinates of one side of the
// court.
Hold over_parapet(float a, float b) {
    const float drop = 1.35f * b;
    const float x = (a - 0.5f) * 1.5f * (1 - 0.6f * b) + 0.1f * std::sin(5 * b);
    const float out = 0.17f + 0.12f * std::min(1.0f, drop * 3) + 0.28f * std::max(0.0f, drop - 0.85f);
    return {{x, 6.14f - drop, out}, glm::normalize(glm::vec3(0, 0.6f * (1 - b), 1))};
}

// Maps (a, b) to a point on the wall that a plant covers. `a` runs along the plant, `b` across it. For `a`
// below 0.45 the plant grows up a corner pier. For larger `a` it follows a curve over the neighbouring arch.
Hold over_arch(float a, float b) {
    constexpr float kUpright = 0.45f;
    const float side = (b - 0.5f) * 2;
    if (a < kUpright) {
        const float spread = (0.25f + 0.3f * a) * side;
        return {{spread, 0.3f + a / kUpright * 4.0f, 0.1f}, {0, 0, 1}};
    }
    const float along = a - kUpright;
    const float spread = (0.6f - 0.45f * along) * side;
    return {{along * 5.2f + 0.2f * spread, 4.3f + std::sin(along * 5.7f) * 0.75f + 0.9f * spread, 0.1f},
            {0, 0, 1}};
}

// Makes the woody stems that bear the leaves. Each vine is a list of points from the root to the tip.
Mesh stems(const std::vector<std::vector<Hold>>& vines, float radius_m) {
    MeshBuilder builder;
    for (const std::vector<Hold>& vine : vines) {
        std::vector<glm::vec3> path;
        for (const Hold& hold : vine) path.push_back(hold.position + hold.outward * (0.5f * radius_m));
        builder.add_tube(path, {radius_m, 0.4f * radius_m, 3});
    }
    return builder.finish("climber_stems");
}

std::vector<std::vector<Hold>> hanging_vines() {
    std::vector<std::vector<Hold>> vines;
    for (const float a : {0.2f, 0.5f, 0.8f}) {
        vines.push_back({{{(a - 0.5f) * 1.5f, 6.05f, 0.0f}, {0, 0, 1}}});
        for (const float b : {0.0f, 0.3f, 0.65f, 1.0f}) vines.back().push_back(over_parapet(a, b));
    }
    return vines;
}

std::vector<std::vector<Hold>> arch_vines() {
    std::vector<std::vector<Hold>> vines;
    for (const float b : {0.3f, 0.5f, 0.75f}) {
        vines.push_back({{{(b - 0.5f) * 0.25f, 0, 0.12f}, {0, 0, 1}}});
        for (const float a : {0.1f, 0.25f, 0.4f, 0.5f, 0.62f, 0.76f, 0.9f})
            vines.back().push_back(over_arch(a, b + 0.16f * std::sin(14 * a + 9 * b)));
    }
    return vines;
}

// Makes the trough on top of the parapet. The hanging ivy grows in the trough.
Mesh trough() {
    MeshBuilder builder;
    builder.add_box({-0.58f, 5.98f, -0.1f}, {0.58f, 6.16f, 0.16f});
    return builder.finish("ivy_trough");
}

}  // namespace

void add_climbers(Parts& parts) {
    const Materials& m = parts.materials;
    const uint32_t column = add_mesh(parts, climber(85, 0.15f, 51, around_column));
    for (const glm::vec3& at : {glm::vec3(-kCourtHalfX, 0, -3), glm::vec3(kCourtHalfX, 0, -3),
                                glm::vec3(3, 0, -kCourtHalfZ), glm::vec3(kCourtHalfX, 0, 6)}) {
        place_copy(parts, column, m.ivy, moved(at, at.x + at.z));
    }
    const uint32_t spill = add_mesh(parts, climber(120, 0.18f, 52, over_parapet));
    const glm::mat4 left = moved({0, 0, 0}, 0.5f * kPi);
    const glm::mat4 right = moved({0, 0, 0}, -0.5f * kPi);
    const uint32_t hanging = add_mesh(parts, stems(hanging_vines(), 0.014f));
    const uint32_t box = add_mesh(parts, trough());
    // Each trough with ivy stands between two posts of the gallery. The posts are 1.5 m apart.
    for (const glm::mat4& at :
         {left * moved({3.75f, 0, -kCourtHalfX}), right * moved({-2.25f, 0, -kCourtHalfX}),
          right * moved({3.75f, 0, -kCourtHalfX})}) {
        place_copy(parts, spill, m.ivy, at);
        place_copy(parts, hanging, m.bark, at);
        place_copy(parts, box, m.clay, at);
    }
    const uint32_t greens = add_mesh(parts, climber(150, 0.19f, 54, over_arch));
    const uint32_t flowers = add_mesh(parts, climber(160, 0.19f, 53, over_arch));
    const glm::vec3 corner{-kCourtHalfX + 0.33f, 0, -kCourtHalfZ + 0.3f};
    place_copy(parts, greens, m.ivy, moved(corner));
    place_copy(parts, flowers, m.blossom, moved(corner + glm::vec3(0, 0, 0.06f)));
    place_copy(parts, add_mesh(parts, stems(arch_vines(), 0.03f)), m.bark, moved(corner));
}

}  // namespace weft::scene::atrium

// Purpose: adds the atrium's citrus trees and ferns in clay pots, and cypresses behind the building. For the
// climbing plants see builtin_atrium_climbers.cpp.
#include <cmath>

#include "scene/builtin/builtin_atrium_leaves.h"
#include "scene/builtin/builtin_atrium_parts.h"
#include "scene/model/angles.h"

namespace weft::scene::atrium {
namespace {

struct PotMeshes {
    uint32_t pot;
    uint32_t soil;
};

PotMeshes make_pots(Parts& parts) {
    MeshBuilder builder;
    builder.add_lathe(
        {{0.2f, 0}, {0.283f, 0.43f}, {0.32f, 0.45f}, {0.325f, 0.51f}, {0.29f, 0.525f}, {0.275f, 0.46f}},
        {12, 0, 2 * kPi, 1, 2});
    const uint32_t pot = add_mesh(parts, builder.finish("clay_pot"));
    builder.add_lathe({{0.28f, 0.47f}, {0, 0.49f}}, {12, 0, 2 * kPi, 0.5f, 1});
    return {pot, add_mesh(parts, builder.finish("pot_soil"))};
}

void place_pot(Parts& parts, const PotMeshes& pots, glm::vec3 at, float turn, float scale) {
    place_copy(parts, pots.pot, parts.materials.clay, moved(at, turn, scale));
    place_copy(parts, pots.soil, parts.materials.soil, moved(at, turn, scale));
    parts.footprints.push_back({{at.x, at.z}, glm::vec2(0.22f * scale), true, 0.5f * scale, 0.85f});
}

constexpr glm::vec3 kCrown{0, 1.95f, 0};

Mesh citrus_crown(Random& random) {
    MeshBuilder leaves;
    for (int i = 0; i < 150; ++i) {
        const glm::vec3 outward = on_sphere(random);
        const float reach = random.range(0.34f, 0.68f);
        const glm::vec3 facing = outward + on_sphere(random) * 0.75f;
        const float roll = random.range(-0.9f, 0.9f);
        const float half = random.range(0.19f, 0.27f);
        Card card = facing_card(kCrown + outward * glm::vec3(1, 0.9f, 1) * reach, facing, roll, half);
        card.soft_normals = true;
        card.normal_center = kCrown - glm::vec3(0, 0.15f, 0);
        leaves.add_card(card);
    }
    return leaves.finish("citrus_crown");
}

Mesh citrus_trunk() {
    MeshBuilder wood;
    wood.add_tube({{0, 0.5f, 0}, {0.03f, 0.9f, 0.02f}, {-0.01f, 1.35f, 0.0f}, {0, 1.8f, 0}},
                  {0.05f, 0.028f, 8});
    for (int i = 0; i < 5; ++i) {
        const float turn = static_cast<float>(i) * 1.2566f;
        const glm::vec3 out{std::cos(turn), 0, std::sin(turn)};
        wood.add_tube(
            {{0, 1.35f, 0}, out * 0.18f + glm::vec3(0, 1.6f, 0), out * 0.42f + glm::vec3(0, 1.95f, 0)},
            {0.022f, 0.01f, 4});
    }
    return wood.finish("citrus_trunk");
}

// Adds citrus trees. Each has a round crown of leaf cards, a short trunk, a few oranges, and a pot that is
// scaled by 1.3.
void add_citrus_trees(Parts& parts, const PotMeshes& pots) {
    const Materials& m = parts.materials;
    Random random(31);
    const uint32_t leaves = add_mesh(parts, citrus_crown(random));
    const uint32_t wood = add_mesh(parts, citrus_trunk());
    MeshBuilder oranges;
    for (int i = 0; i < 4; ++i) {
        oranges.add_sphere(kCrown + on_sphere(random) * glm::vec3(0.66f, 0.58f, 0.66f), 0.047f, 7, 4);
    }
    const uint32_t fruit = add_mesh(parts, oranges.finish("citrus_fruit"));
    float turn = 0.3f;
    for (const glm::vec2& at : {glm::vec2(-4.35f, -7.25f), glm::vec2(4.35f, -7.25f), glm::vec2(-4.5f, 5.9f),
                                glm::vec2(4.85f, 5.3f)}) {
        const glm::mat4 to_world = moved({at.x, 0.12f, at.y}, turn);
        place_pot(parts, pots, {at.x, 0, at.y}, turn, 1.3f);
        place_copy(parts, leaves, m.citrus, to_world);
        place_copy(parts, wood, m.bark, to_world);
        place_copy(parts, fruit, m.orange, to_world);
        turn += 1.7f;
    }
}

// Makes a fern: a tuft of curved fronds. Each frond is a strip that rises, bends over and hangs down.
Mesh fern_tuft(uint32_t count, float length, uint32_t seed) {
    Random random(seed);
    MeshBuilder builder;
    for (uint32_t k = 0; k < count; ++k) {
        const float turn = static_cast<float>(k) * 2.39996f;
        const glm::vec3 out{std::cos(turn), 0, std::sin(turn)};
        const glm::vec3 side{-out.z, 0, out.x};
        const float rise = random.range(0.75f, 1.25f);
        const float reach = length * random.range(0.85f, 1.1f);
        const float half = 0.17f * reach / 0.7f;
        builder.add_grid(2, 5, [&](uint32_t i, uint32_t j) {
            const float t = static_cast<float>(j) / 4;
            const float bend = rise - 2.0f * t * t;
            const glm::vec3 p = out * (reach * (0.04f + t * (0.35f + 0.5f * t))) +
                                glm::vec3(0, reach * (rise * t - 0.85f * t * t) + 0.02f * bend, 0);
            const float across = i == 0 ? 1.0f : -1.0f;
            return GridPoint{p + side * (across * half), {0.5f - 0.5f * across, 1 - t}};
        });
    }
    return builder.finish("fern");
}

void add_ferns(Parts& parts, const PotMeshes& pots) {
    const Materials& m = parts.materials;
    const uint32_t tuft = add_mesh(parts, fern_tuft(13, 0.72f, 41));
    struct Place {
        glm::vec3 at;
        float scale;
    };
    std::vector<Place> places{
        {{-5.05f, 0, -3.0f}, 0.9f},      {{-5.05f, 0, 3.0f}, 0.9f},   {{5.05f, 0, -3.0f}, 0.9f},
        {{5.05f, 0, 3.0f}, 0.9f},        {{5.0f, 0, 0.1f}, 0.75f},    {{4.55f, 0, -0.45f}, 0.6f},
        {{-8.65f, kFloor, -8.6f}, 1},    {{8.65f, kFloor, -8.6f}, 1}, {{-8.8f, kFloor, -0.35f}, 0.85f},
        {{-8.8f, kFloor, -2.65f}, 0.8f}, {{2.5f, 0, -3.6f}, 0.8f},    {{-2.5f, 0, -4.2f}, 0.8f}};
    float turn = 0;
    for (const Place& place : places) {
        place_pot(parts, pots, place.at, turn, place.scale);
        place_copy(parts, tuft, m.fern,
                   moved(place.at + glm::vec3(0, 0.46f * place.scale, 0), turn, 1.05f * place.scale));
        turn += 1.1f;
    }
    for (const float end : {-1.0f, 1.0f}) {  // Small ferns in pots stand on the pedestals of both terraces.
        for (int i = -1; i <= 1; ++i) {
            const glm::vec3 at{static_cast<float>(i) * kBay, 5.98f, end * kCourtHalfZ};
            place_copy(parts, pots.pot, m.clay, moved(at, turn, 0.62f));
            place_copy(parts, tuft, m.fern, moved(at + glm::vec3(0, 0.29f, 0), turn, 0.85f));
            turn += 1.3f;
        }
    }
}

void add_cypresses(Parts& parts) {
    Random random(61);
    MeshBuilder builder;
    constexpr uint32_t kCards = 105;
    constexpr float kHeight = 9.6f;
    for (uint32_t i = 0; i < kCards; ++i) {
        // The twigs are denser towards the top of the tree, because only the top is visible above the roofs.
        const float t = 0.03f + 0.97f * std::pow((static_cast<float>(i) + random.unit()) / kCards, 1.25f);
        const float y = kHeight * (1 - t);
        const float turn = static_cast<float>(i) * 2.39996f;
        const glm::vec3 outward{std::cos(turn), 0, std::sin(turn)};
        const float radius = 0.62f * std::pow(t, 0.6f) * random.range(0.75f, 1.05f);
        const glm::vec3 facing = outward + glm::vec3(0, 0.25f, 0) + on_sphere(random) * 0.3f;
        const float roll = random.range(-0.2f, 0.2f);
        Card card = facing_card(outward * radius + glm::vec3(0, y, 0), facing, roll, 0.26f + 0.38f * t);
        card.soft_normals = true;
        card.normal_center = {0, y - 0.4f, 0};
        builder.add_card(card);
    }
    const uint32_t tree = add_mesh(parts, builder.finish("cypress"));
    for (const glm::vec4& at :
         {glm::vec4(-3.9f, -0.03f, -13.9f, 1.0f), glm::vec4(-2.2f, -0.03f, -14.2f, 0.84f),
          glm::vec4(3.9f, -0.03f, -13.9f, 0.93f), glm::vec4(-2.5f, -0.03f, 13.9f, 1.0f),
          glm::vec4(3.1f, -0.03f, 14.0f, 0.9f)}) {
        place_copy(parts, tree, parts.materials.cypress, moved(glm::vec3(at), at.x * 2, at.w));
    }
}

}  // namespace

void add_plants(Parts& parts) {
    const PotMeshes pots = make_pots(parts);
    add_citrus_trees(parts, pots);
    add_ferns(parts, pots);
    add_cypresses(parts);
    for (const glm::vec3& at : {glm::vec3(8.6f, kFloor, 4.2f), glm::vec3(8.75f, kFloor, 4.85f)}) {
        place_pot(parts, pots, at, at.z, 0.9f);  // Places a pot with soil but without a plant.
    }
}

}  // namespace weft::scene::atrium

#include "scene/builtin/builtin_stage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <utility>

#include "scene/builtin/scene_parts.h"
#include "scene/model/angles.h"
#include "scene/procedural/procedural_mesh.h"
#include "scene/procedural/procedural_noise.h"
#include "scene/procedural/procedural_texture.h"

namespace weft::scene {
namespace {

constexpr uint32_t kPictureSize_px = 256;

uint32_t add_material(Scene& scene, const char* name, glm::vec3 color, float roughness, float metallic = 0) {
    Material material;
    material.name = name;
    material.base_color = glm::vec4(color, 1);
    material.metallic = metallic;
    material.roughness = roughness;
    scene.materials.push_back(std::move(material));
    return static_cast<uint32_t>(scene.materials.size() - 1);
}

// Adds an emissive material for the visible surface of a lamp. `luminance` is in cd/m².
uint32_t add_glow(Scene& scene, const char* name, glm::vec3 luminance) {
    const uint32_t material = add_material(scene, name, glm::vec3(0), 1);
    scene.materials[material].emissive = luminance;
    return material;
}

void add(Scene& scene, MeshBuilder& builder, const char* name, uint32_t material) {
    scene.meshes.push_back(builder.finish(name));
    scene.instances.push_back({name, static_cast<uint32_t>(scene.meshes.size() - 1), material, glm::mat4(1)});
}

// Returns the transform from the local space of a lamp to world space. In local space, x is along the lamp's
// width, y is up, and the lamp faces −z.
glm::mat4 lamp_axes(glm::vec3 at, glm::vec3 target) {
    return glm::inverse(glm::lookAt(at, target, glm::vec3(0, 1, 0)));
}

Light lamp(const char* name, LightType type, const glm::mat4& axes, glm::vec3 color, float intensity) {
    Light light;
    light.name = name;
    light.type = type;
    light.color = color;
    light.intensity = intensity;
    light.position = glm::vec3(axes[3]);
    light.direction = -glm::vec3(axes[2]);
    light.side = glm::vec3(axes[0]);
    return light;
}

uint32_t add_function(Scene& scene, LightFunction function) {
    scene.light_functions.push_back(std::move(function));
    return static_cast<uint32_t>(scene.light_functions.size() - 1);
}

void add_room(Scene& scene) {
    Random random(7);
    constexpr int kBoards = 30;
    constexpr float kWidth = 9, kFront = 4.5f, kBack = -3;
    const std::array<uint32_t, 3> woods{add_material(scene, "dark board", {0.11f, 0.07f, 0.048f}, 0.34f),
                                        add_material(scene, "board", {0.135f, 0.087f, 0.058f}, 0.4f),
                                        add_material(scene, "worn board", {0.165f, 0.11f, 0.075f}, 0.48f)};
    std::array<MeshBuilder, 3> boards;
    for (int i = 0; i < kBoards; ++i) {
        const float step = 2 * kWidth / kBoards, x = -kWidth + static_cast<float>(i) * step;
        boards[std::min(2u, static_cast<uint32_t>(random.unit() * 3))].add_bevelled_box(
            {x + 0.003f, -0.06f, kBack}, {x + step - 0.003f, 0, kFront}, 0.006f);
    }
    for (size_t i = 0; i < woods.size(); ++i) add(scene, boards[i], "boards", woods[i]);
    MeshBuilder walls;
    walls.add_rectangle({-kWidth, 0, kBack}, {2 * kWidth, 0, 0}, {0, 6.5f, 0});
    add(scene, walls, "back wall", add_material(scene, "plaster", {0.34f, 0.33f, 0.35f}, 0.85f));
}

// Adds a curtain with folds. `from` is its upper left corner, seen from the front.
void add_curtain(Scene& scene, const char* name, glm::vec3 from, float width_m, float height_m,
                 uint32_t material) {
    constexpr uint32_t kColumns = 96;
    constexpr float kFold_m = 0.34f, kDeep_m = 0.11f;
    MeshBuilder builder;
    builder.add_grid(kColumns, 2, [&](uint32_t column, uint32_t row) {
        const float x = width_m * static_cast<float>(column) / (kColumns - 1),
                    y = row == 0 ? -height_m : 0.0f;
        const float swing = std::sin(2 * kPi * x / kFold_m + 0.7f * std::sin(3 * x));
        return GridPoint{from + glm::vec3(x, y, kDeep_m * swing), {x, -y}};
    });
    add(scene, builder, name, material);
}

void add_set(Scene& scene) {
    const uint32_t velvet = add_material(scene, "velvet", {0.2f, 0.016f, 0.03f}, 0.75f);
    scene.materials[velvet].double_sided = true;
    add_curtain(scene, "left curtain", {-5.6f, 6.2f, 0.6f}, 2.2f, 6.18f, velvet);
    add_curtain(scene, "right curtain", {3.4f, 6.2f, 0.6f}, 2.2f, 6.18f, velvet);
    const uint32_t stone = add_material(scene, "stone", {0.5f, 0.47f, 0.42f}, 0.55f);
    MeshBuilder dais;
    dais.add_lathe({{1.5f, 0}, {1.5f, 0.17f}, {1.47f, 0.2f}, {0, 0.2f}}, {.segments = 96});
    add(scene, dais, "dais", stone);
    const uint32_t glaze = add_material(scene, "glaze", {0.045f, 0.12f, 0.17f}, 0.16f);
    MeshBuilder vase;
    vase.set_transform(glm::translate(glm::mat4(1), glm::vec3(-0.35f, 0.2f, 0.1f)));
    vase.add_lathe({{0, 0},
                    {0.22f, 0},
                    {0.25f, 0.05f},
                    {0.36f, 0.35f},
                    {0.42f, 0.62f},
                    {0.39f, 0.86f},
                    {0.26f, 1.08f},
                    {0.15f, 1.22f},
                    {0.14f, 1.34f},
                    {0.21f, 1.45f},
                    {0.19f, 1.46f}},
                   {.segments = 64});
    add(scene, vase, "vase", glaze);
    MeshBuilder ball;
    ball.add_sphere({0.75f, 0.55f, 0.35f}, 0.35f, 64, 32);
    add(scene, ball, "ball", add_material(scene, "brass", {0.88f, 0.62f, 0.26f}, 0.24f, 1));
    MeshBuilder crate;
    crate.set_transform(glm::translate(glm::mat4(1), glm::vec3(2.35f, 0, -0.7f)) *
                        glm::rotate(glm::mat4(1), 0.5f, glm::vec3(0, 1, 0)));
    crate.add_bevelled_box({-0.45f, 0, -0.45f}, {0.45f, 0.9f, 0.45f}, 0.02f);
    add(scene, crate, "crate", add_material(scene, "white paint", {0.72f, 0.71f, 0.69f}, 0.6f));
}

// A leaf in the picture of add_foliage_picture(). Lengths are relative to the width of the picture.
struct Leaf {
    glm::vec2 at{0};        // Centre of the leaf.
    glm::vec2 along{1, 0};  // Unit vector along the leaf.
    float length = 0.1f;
};

// Generates the leaves for a picture that a light projects: leaves on both sides of twigs that grow across
// the picture.
std::vector<Leaf> grow_leaves() {
    Random random(5);
    std::vector<Leaf> leaves;
    for (int twig = 0; twig < 9; ++twig) {
        glm::vec2 at(random.range(-0.1f, 0.9f), random.range(-0.1f, 1.1f));
        float heading = random.range(-0.9f, 0.5f);
        for (int i = 0; i < 13; ++i) {
            const float side = i % 2 == 0 ? 1.0f : -1.0f, turn = heading + side * random.range(0.5f, 1.1f);
            const float length = random.range(0.06f, 0.105f);
            const glm::vec2 along(std::cos(turn), std::sin(turn));
            leaves.push_back({at + along * length * 0.55f, along, length});
            at += 0.038f * glm::vec2(std::cos(heading), std::sin(heading));
            heading += random.range(-0.16f, 0.16f);
        }
    }
    return leaves;
}

// Returns the distance from `at` to the edge of a leaf: positive inside the leaf, negative outside. The
// outline of a leaf consists of two arcs that meet at its tips.
float inside_leaf(const Leaf& leaf, glm::vec2 at) {
    const glm::vec2 way = at - leaf.at;
    const float half = leaf.length * 0.5f, width = half * 0.42f;
    const float radius = (half * half + width * width) / (2 * width);
    const glm::vec2 place(glm::dot(way, leaf.along), std::abs(way.y * leaf.along.x - way.x * leaf.along.y));
    return radius - glm::length(place + glm::vec2(0, radius - width));
}

// Adds the picture that a spot projects: the shadow of leaves in front of a round window.
uint32_t add_foliage_picture(Scene& scene) {
    const std::vector<Leaf> leaves = grow_leaves();
    std::vector<glm::vec3> texels;
    for (uint32_t y = 0; y < kPictureSize_px; ++y) {
        for (uint32_t x = 0; x < kPictureSize_px; ++x) {
            const glm::vec2 at = (glm::vec2(x, y) + 0.5f) / static_cast<float>(kPictureSize_px);
            float deepest = -1;
            for (const Leaf& leaf : leaves) deepest = std::max(deepest, inside_leaf(leaf, at));
            const float rim = smooth_step(0.98f, 0.8f, 2 * glm::distance(at, glm::vec2(0.5f)));
            texels.emplace_back(rim * (1 - 0.93f * smooth_step(-0.006f, 0.006f, deepest)));
        }
    }
    return add_color_texture(scene, "foliage", kPictureSize_px, texels);
}

// Adds the picture of a lantern's cage: rows of round holes, every second row shifted. The picture is wrapped
// around a sphere, so rows near the poles have fewer holes.
uint32_t add_lantern_picture(Scene& scene) {
    constexpr float kRows = 10;
    std::vector<glm::vec3> texels;
    for (uint32_t y = 0; y < kPictureSize_px; ++y) {
        for (uint32_t x = 0; x < kPictureSize_px; ++x) {
            const glm::vec2 at = (glm::vec2(x, y) + 0.5f) / static_cast<float>(kPictureSize_px);
            const float row = std::floor(at.y * kRows), level = std::sin(kPi * (row + 0.5f) / kRows);
            const float holes = std::max(1.0f, std::round(2 * kRows * level));
            const float shift = std::fmod(row, 2.0f) < 1 ? 0.0f : 0.5f;
            const float along = at.x * holes + shift;
            const glm::vec2 off((along - std::floor(along) - 0.5f) * 2 * kRows * level / holes,
                                at.y * kRows - row - 0.5f);
            const float open = smooth_step(0.34f, 0.26f, glm::length(off));
            texels.emplace_back(0.05f + 0.95f * open);
        }
    }
    return add_color_texture(scene, "lantern", kPictureSize_px, texels);
}

void add_leaf_spot(Scene& scene, uint32_t iron) {
    const glm::mat4 axes = lamp_axes({-3.6f, 5.4f, 4.2f}, {0.2f, 1.6f, -2.4f});
    Light light = lamp("leaves", LightType::spot, axes, {1, 0.78f, 0.52f}, 9000);
    light.inner_cone_rad = 0.46f;
    light.outer_cone_rad = 0.5f;
    light.range_m = 16;
    LightFunction function;
    function.name = "leaves";
    function.picture = add_foliage_picture(scene);
    function.picture_half_size = glm::vec2(0.47f);
    light.function = add_function(scene, function);
    scene.lights.push_back(light);
    MeshBuilder housing;
    housing.set_transform(axes * glm::rotate(glm::mat4(1), -kPi / 2, glm::vec3(1, 0, 0)));
    housing.add_lathe({{0, -0.3f}, {0.13f, -0.3f}, {0.16f, 0.06f}, {0.15f, 0.06f}, {0.12f, -0.25f}},
                      {.segments = 32});
    add(scene, housing, "leaf spot", iron);
}

// Adds four barn doors (movable flaps) at the edges of a lamp's rectangular window. `half` is half of the
// window's size in metres. `doors` are the angles of the doors in radians: left, right, bottom, top. At 0 a
// door points straight forward; at a positive angle it points outwards.
void add_barn_doors(MeshBuilder& builder, const glm::mat4& axes, glm::vec2 half, const glm::vec4& doors) {
    constexpr float kLong_m = 0.3f;
    for (int i = 0; i < 4; ++i) {
        const bool upright = i < 2;
        const float sign = i % 2 == 0 ? -1.0f : 1.0f, angle = doors[i];
        const float reach = upright ? half.x : half.y, length = upright ? half.y : half.x;
        const glm::mat4 turned =
            axes * glm::rotate(glm::mat4(1), upright ? 0.0f : kPi / 2, glm::vec3(0, 0, 1));
        builder.set_transform(turned * glm::translate(glm::mat4(1), glm::vec3(sign * reach, 0, 0)) *
                              glm::rotate(glm::mat4(1), -sign * angle, glm::vec3(0, 1, 0)));
        builder.add_box({-0.006f, -length, -kLong_m}, {0.006f, length, 0});
    }
}

void add_soft_box(Scene& scene, uint32_t iron) {
    const glm::mat4 axes = lamp_axes({2.75f, 3.1f, -0.9f}, {-0.1f, 0.5f, 0.6f});
    Light light = lamp("window", LightType::rectangle, axes, {0.62f, 0.8f, 1}, 900);
    light.half_size_m = {0.4f, 0.6f};
    light.range_m = 12;
    LightFunction function;
    function.name = "doors";
    function.doors = {0.42f, 0.42f, 0.6f, 0.3f};
    function.softness = 0.12f;
    light.function = add_function(scene, function);
    scene.lights.push_back(light);
    MeshBuilder front;
    front.set_transform(axes);
    front.add_rectangle({0.4f, -0.6f, 0}, {-0.8f, 0, 0}, {0, 1.2f, 0});
    add(scene, front, "window", add_glow(scene, "window", light.color * light.intensity));
    MeshBuilder housing;
    housing.set_transform(axes);
    housing.add_bevelled_box({-0.43f, -0.63f, 0.004f}, {0.43f, 0.63f, 0.2f}, 0.02f);
    add_barn_doors(housing, axes, {0.42f, 0.62f}, function.doors);
    add(scene, housing, "soft box", iron);
}

void add_tube(Scene& scene, const char* name, glm::vec3 from, glm::vec3 to, glm::vec3 color) {
    constexpr float kRadius_m = 0.03f;
    Light light;
    light.name = name;
    light.type = LightType::capsule;
    light.color = color;
    light.intensity = 1600;
    light.position = (from + to) * 0.5f;
    light.direction = glm::normalize(to - from);
    light.half_size_m = {glm::distance(from, to) * 0.5f, kRadius_m};
    light.range_m = 7;
    scene.lights.push_back(light);
    MeshBuilder tube;
    tube.add_tube({from, to}, {.radius_start_m = kRadius_m, .radius_end_m = kRadius_m, .segments = 24});
    tube.add_sphere(from, kRadius_m, 24, 12);
    tube.add_sphere(to, kRadius_m, 24, 12);
    add(scene, tube, name, add_glow(scene, name, light.color * light.intensity));
}

void add_lantern(Scene& scene, uint32_t iron) {
    const glm::vec3 at(-2.5f, 1.15f, 0.5f);
    glm::mat4 axes(1);
    axes[3] = glm::vec4(at, 1);
    Light light = lamp("lantern", LightType::point, axes, {1, 0.55f, 0.22f}, 240);
    light.range_m = 6;
    LightFunction function;
    function.name = "lantern";
    function.picture = add_lantern_picture(scene);
    // The curve is a factor for the inverse-square falloff. It starts at 0.1, so the light near the lantern
    // is weaker than the inverse square. It ends at 0, so there is no light from 3.4 m on.
    function.curve = {0.1f, 0.7f, 1.6f, 0};
    function.reach_m = 3.4f;
    light.function = add_function(scene, function);
    scene.lights.push_back(light);
    MeshBuilder glass;
    glass.add_sphere(at, 0.1f, 32, 16);
    add(scene, glass, "lantern glass", add_glow(scene, "lantern glass", glm::vec3(1, 0.55f, 0.22f) * 260.0f));
    MeshBuilder cage;
    for (int i = 0; i < 4; ++i) {
        cage.set_transform(glm::translate(glm::mat4(1), at) *
                           glm::rotate(glm::mat4(1), kPi / 4 * static_cast<float>(i), glm::vec3(0, 1, 0)) *
                           glm::rotate(glm::mat4(1), kPi / 2, glm::vec3(1, 0, 0)));
        cage.add_torus(0.14f, 0.008f, 48, 8);
    }
    cage.set_transform(glm::mat4(1));
    cage.add_tube({at + glm::vec3(0, 0.14f, 0), at + glm::vec3(0, 6, 0)},
                  {.radius_start_m = 0.008f, .radius_end_m = 0.008f});
    add(scene, cage, "lantern cage", iron);
}

Camera camera(const char* name, glm::vec3 eye, glm::vec3 at, float fov_y_deg) {
    Camera made;
    made.name = name;
    made.transform = lamp_axes(eye, at);
    made.fov_y_rad = glm::radians(fov_y_deg);
    return made;
}

}  // namespace

Scene make_stage() {
    Scene scene;
    scene.name = "stage";
    add_room(scene);
    add_set(scene);
    const uint32_t iron = add_material(scene, "iron", {0.03f, 0.03f, 0.032f}, 0.45f, 0.6f);
    add_leaf_spot(scene, iron);
    add_soft_box(scene, iron);
    add_tube(scene, "coral tube", {-2.9f, 2.6f, -2.7f}, {-1.5f, 4.4f, -2.7f}, {1, 0.16f, 0.2f});
    add_tube(scene, "sea tube", {2.2f, 0.25f, -2.6f}, {3.3f, 0.25f, -1.7f}, {0.08f, 0.62f, 1});
    add_lantern(scene, iron);
    scene.cameras.push_back(camera("front", {0.2f, 2.0f, 8.6f}, {0, 1.75f, 0}, 34));
    scene.cameras.push_back(camera("wing", {-4.6f, 1.7f, 4.4f}, {0.5f, 1.1f, -0.4f}, 44));
    finish_scene(scene, glm::vec3(1.1f, 1.2f, 1.6f), glm::vec3(1.1f, 1.2f, 1.6f), -5.6f);
    return scene;
}

}  // namespace weft::scene

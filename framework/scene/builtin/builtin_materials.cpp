#include "scene/builtin/builtin_materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <string>

#include "scene/builtin/builtin_hair.h"
#include "scene/builtin/scene_parts.h"
#include "scene/model/angles.h"
#include "scene/procedural/procedural_mesh.h"
#include "scene/procedural/procedural_noise.h"
#include "scene/procedural/procedural_texture.h"

namespace weft::scene {
namespace {

const glm::vec3 kLanternMiddle{1.62f, 0.62f, -0.2f};

// Adds silk that hangs over a ball on a post. Its threads run along the tangents, so the highlight is wide
// across them.
void add_silk(Scene& scene) {
    constexpr uint32_t kSpokes = 145, kRings = 40;
    constexpr float kRadius = 0.3f, kTop = 0.98f, kLength = 0.8f;
    MeshBuilder builder;
    builder.add_grid(kSpokes, kRings, [&](uint32_t spoke, uint32_t ring) {
        const float angle = 2 * kPi * static_cast<float>(spoke) / (kSpokes - 1);
        const float along = kLength * (1 - static_cast<float>(ring) / (kRings - 1));
        const float bend = std::min(along / kRadius, 0.5f * kPi);
        const float hanging = std::max(along - 0.5f * kPi * kRadius, 0.0f);
        const float folds = 0.5f + 0.36f * std::sin(9 * angle + 0.8f * std::sin(2 * angle)) +
                            0.14f * std::sin(23 * angle + 4 * along);
        const float depth = std::min(hanging * 0.55f, 0.16f);
        const float radius = kRadius * std::sin(bend) + depth * (folds - 0.25f) + 0.01f;
        const float height = kTop - kRadius * (1 - std::cos(bend)) - hanging;
        return GridPoint{{radius * std::sin(angle), height, radius * std::cos(angle)},
                         {angle * kRadius, along}};
    });
    Material silk;
    silk.name = "silk";
    silk.base_color = {0.05f, 0.16f, 0.2f, 1};
    silk.metallic = 0;
    silk.roughness = 0.4f;
    silk.ior = 1.7f;
    silk.specular_color = {0.8f, 0.95f, 1};
    silk.anisotropy = 0.85f;
    silk.double_sided = true;
    const uint32_t material = add_material(scene, silk);
    const glm::mat4 at = glm::translate(glm::mat4(1), glm::vec3(-0.52f, 0, -0.35f));
    place(scene, builder.finish("silk"), material, at);
    MeshBuilder post;
    post.add_lathe({{0.18f, 0}, {0.18f, 0.03f}, {0.03f, 0.05f}, {0.03f, kTop - kRadius}}, {.segments = 24});
    place(scene, post.finish("post"), add_matt(scene, "iron", {0.08f, 0.08f, 0.08f}, 0.5f), at);
}

// Gives the ice frost, which is rougher and whiter than clear ice, and a surface that is not quite flat.
void add_frost(Scene& scene, Material& ice) {
    constexpr uint32_t kSize = 256;
    const NoiseBank noise = make_noise_bank(kSize);
    const Surface frost = make_surface(kSize, 1, [&](uint32_t x, uint32_t y) {
        Texel texel;
        const float veins = 1 - std::abs(noise.coarse.at(x, y) - 0.5f) * 9;
        const float white =
            smooth_step(0.1f, 1, veins) + 0.5f * smooth_step(0.55f, 0.8f, noise.medium.at(x, y));
        texel.color_srgb = glm::mix(glm::vec3(0.72f, 0.84f, 0.9f), glm::vec3(0.97f), std::min(white, 1.0f));
        texel.roughness = 0.1f + 0.4f * std::min(white, 1.0f);
        texel.height_m = 0.014f * noise.coarse.at(x, y) + 0.0012f * noise.medium.at(x, y);
        return texel;
    });
    const SurfaceTextures textures = add_surface(scene, "frost", frost);
    ice.base_color_texture.texture = textures.color;
    ice.metallic_roughness_texture.texture = textures.metallic_roughness;
    ice.normal_texture.texture = textures.normal;
}

// Adds blocks of ice. Light that enters at the back is scattered and turns blue on its way to the front.
void add_ice(Scene& scene) {
    constexpr float kSide = 0.42f;
    Material ice;
    ice.name = "ice";
    ice.metallic = 0;
    add_frost(scene, ice);
    ice.ior = 1.31f;
    ice.diffuse_transmission = 0.8f;
    ice.diffuse_transmission_color = {0.92f, 0.97f, 1};
    ice.thickness_m = kSide;
    ice.absorption_per_m = {2.2f, 0.6f, 0.2f};
    const uint32_t material = add_material(scene, ice);
    struct Block {
        glm::vec3 at;
        float turn_rad;
    };
    const std::array<Block, 3> blocks{
        {{{0.38f, 0, -0.5f}, 0.25f}, {{0.88f, 0, -0.42f}, -0.18f}, {{0.62f, kSide, -0.46f}, 0.6f}}};
    for (const Block& block : blocks) {
        MeshBuilder builder;
        builder.set_uv_offset(glm::vec2(block.at));
        builder.add_bevelled_box({-kSide / 2, 0, -kSide / 2}, {kSide / 2, kSide, kSide / 2}, 0.035f);
        place(scene, builder.finish("ice"), material,
              glm::rotate(glm::translate(glm::mat4(1), block.at), block.turn_rad, glm::vec3(0, 1, 0)));
    }
}

// Adds a lantern of paper with a lamp in it. The paper is a thin sheet, open at the top and the bottom.
void add_paper_lantern(Scene& scene) {
    constexpr float kRadius = 0.3f, kOpening = 0.4f;
    Profile profile;
    for (int i = 0; i <= 28; ++i) {
        const float angle = -kPi / 2 + kOpening + (kPi - 2 * kOpening) * static_cast<float>(i) / 28;
        const float rib = 0.006f * (i % 2 == 0 ? 1.0f : -1.0f);
        profile.emplace_back((kRadius + rib) * std::cos(angle), kRadius * std::sin(angle));
    }
    MeshBuilder shade;
    shade.add_lathe(profile, {.segments = 48});
    Material paper;
    paper.name = "paper";
    paper.base_color = {0.88f, 0.8f, 0.66f, 1};
    paper.metallic = 0;
    paper.roughness = 0.9f;
    paper.diffuse_transmission = 0.55f;
    paper.diffuse_transmission_color = {1, 0.8f, 0.5f};
    paper.double_sided = true;
    place(scene, shade.finish("lantern"), add_material(scene, paper),
          glm::translate(glm::mat4(1), kLanternMiddle));
    MeshBuilder hook;
    hook.add_tube({{0, 0.24f, 0}, {0, 3, 0}}, {0.006f, 0.006f, 6});
    place(scene, hook.finish("cord"), add_matt(scene, "cord", {0.05f, 0.04f, 0.04f}, 0.8f),
          glm::translate(glm::mat4(1), kLanternMiddle));
}

// Adds two balls that differ only in the roughness of their diffuse reflection.
void add_plaster(Scene& scene) {
    const std::array<float, 2> roughness_rad{0, 0.9f};
    for (size_t i = 0; i < roughness_rad.size(); ++i) {
        const std::string name = i == 0 ? "smooth plaster" : "rough plaster";
        const uint32_t material = add_matt(scene, name.c_str(), {0.62f, 0.6f, 0.56f}, 1);
        scene.materials[material].specular = 0;
        scene.materials[material].diffuse_roughness_rad = roughness_rad[i];
        MeshBuilder builder;
        builder.add_sphere({0, 0.2f, 0}, 0.2f, 64, 32);
        const glm::vec3 at(0.25f + 0.5f * static_cast<float>(i), 0, 0.75f);
        place(scene, builder.finish(name), material, glm::translate(glm::mat4(1), at));
    }
}

void add_lamps_of_materials(Scene& scene) {
    const std::array<PointLamp, 4> lamps{{{"key", {-2.6f, 2.7f, 2.6f}, {1.0f, 0.82f, 0.62f}, 640},
                                          {"behind the ice", {0.62f, 1.5f, -1.15f}, {0.75f, 0.88f, 1.0f}, 30},
                                          {"fill", {2.9f, 2.2f, 2.6f}, {0.6f, 0.75f, 1.0f}, 160},
                                          {"lantern", kLanternMiddle, {1.0f, 0.72f, 0.42f}, 9}}};
    add_point_lamps(scene, lamps, 12);
}

}  // namespace

Scene make_materials() {
    Scene scene;
    scene.name = "materials";
    const uint32_t table = add_matt(scene, "slate", {0.06f, 0.065f, 0.07f}, 0.4f);
    const uint32_t wall = add_matt(scene, "wall", {0.24f, 0.22f, 0.21f}, 0.9f);
    add_table_and_wall(scene, {.half_m = 6, .wall_z_m = -1.5f, .table = table, .wall = wall});
    add_hair_on_stand(scene, {-1.45f, 0, -0.1f});
    add_silk(scene);
    add_ice(scene);
    add_paper_lantern(scene);
    add_plaster(scene);
    add_lamps_of_materials(scene);
    Camera camera;
    camera.name = "table";
    camera.transform = glm::inverse(
        glm::lookAt(glm::vec3(0.15f, 1.55f, 4.9f), glm::vec3(0.08f, 0.5f, -0.1f), glm::vec3(0, 1, 0)));
    camera.fov_y_rad = glm::radians(28.0f);
    scene.cameras.push_back(camera);
    finish_scene(scene, glm::vec3(6, 8, 12), glm::vec3(9, 9, 10), -5.6f);
    return scene;
}

}  // namespace weft::scene

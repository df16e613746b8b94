#include "scene/builtin/builtin_brushed.h"

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <utility>

#include "scene/builtin/scene_parts.h"
#include "scene/pictures/mip_chain.h"
#include "scene/procedural/procedural_mesh.h"

namespace weft::scene {
namespace {

constexpr float kQuarterTurn = 1.5707963268f;

struct Metal {
    const char* name;
    glm::vec3 color;
    float roughness;
    float anisotropy;
};

// Adds a brushed metal. The tangents of the meshes run along the grain of the metal. Without a rotation, the
// specular highlight would be wide along the tangent. anisotropy_rotation_rad = 90° makes the highlight wide
// across the grain.
uint32_t add_metal(Scene& scene, const Metal& metal) {
    Material material;
    material.name = metal.name;
    material.base_color = glm::vec4(metal.color, 1);
    material.roughness = metal.roughness;
    material.anisotropy = metal.anisotropy;
    material.anisotropy_rotation_rad = kQuarterTurn;
    return add_material(scene, std::move(material));
}

// Adds a steel pot with its lid, and a brass knob on the lid. The pot is made as on a lathe, so its grain
// runs around the axis.
void add_pot(Scene& scene) {
    const uint32_t steel = add_metal(scene, {"turned steel", {0.62f, 0.63f, 0.65f}, 0.34f, 0.9f});
    MeshBuilder builder;
    const LatheShape shape{.segments = 96};
    builder.add_lathe({{0.78f, 0.0f}, {0.82f, 0.05f}, {0.82f, 0.92f}, {0.84f, 0.95f}, {0.84f, 0.98f}}, shape);
    builder.add_lathe({{0.84f, 0.98f}, {0.8f, 1.01f}, {0.1f, 1.07f}}, shape);
    place(scene, builder.finish("pot"), steel, glm::translate(glm::mat4(1), glm::vec3(-1.35f, 0, -0.35f)));
    MeshBuilder knob;
    knob.add_lathe(
        {{0.1f, 1.06f}, {0.06f, 1.1f}, {0.07f, 1.16f}, {0.13f, 1.2f}, {0.12f, 1.24f}, {0.01f, 1.26f}},
        {.segments = 32});
    const uint32_t brass = add_metal(scene, {"brass", {0.89f, 0.71f, 0.36f}, 0.22f, 0});
    place(scene, knob.finish("knob"), brass, glm::translate(glm::mat4(1), glm::vec3(-1.35f, 0, -0.35f)));
}

// Adds copper balls that differ only in the strength of their anisotropy.
void add_balls(Scene& scene) {
    const std::array<float, 3> strengths{0.0f, 0.6f, 0.95f};
    for (size_t i = 0; i < strengths.size(); ++i) {
        const std::string name = "copper ball " + std::to_string(i);
        const uint32_t copper = add_metal(scene, {name.c_str(), {0.93f, 0.56f, 0.44f}, 0.3f, strengths[i]});
        MeshBuilder builder;
        builder.add_sphere({0, 0.34f, 0}, 0.34f, 64, 32);
        const glm::vec3 at(-0.1f + 0.85f * static_cast<float>(i), 0, 1.15f);
        place(scene, builder.finish(name), copper, glm::translate(glm::mat4(1), at));
    }
}

// Adds a texture of grain directions. It shows a star of eight sectors; each sector is brushed along its own
// centre line.
uint32_t add_star_of_grains(Scene& scene) {
    constexpr uint32_t kSize = 128;
    constexpr float kSector = 2 * kQuarterTurn / 4;
    std::vector<uint8_t> texels;
    for (uint32_t y = 0; y < kSize; ++y)
        for (uint32_t x = 0; x < kSize; ++x) {
            const glm::vec2 out = glm::vec2(x, kSize - 1 - y) + 0.5f - 0.5f * kSize;
            const float angle = std::round(std::atan2(out.y, out.x) / kSector) * kSector;
            const glm::vec2 encoded = glm::vec2(std::cos(angle), std::sin(angle)) * 0.5f + 0.5f;
            for (const float channel : {encoded.x, encoded.y, 1.0f, 1.0f})
                texels.push_back(static_cast<uint8_t>(std::lround(channel * 255)));
        }
    Texture texture;
    texture.name = "star of grains";
    texture.width_px = texture.height_px = kSize;
    texture.mips = build_mip_chain(kSize, kSize, std::move(texels), {});
    scene.textures.push_back(std::move(texture));
    return static_cast<uint32_t>(scene.textures.size() - 1);
}

void add_plates(Scene& scene) {
    const glm::mat4 leaning =
        glm::rotate(glm::translate(glm::mat4(1), glm::vec3(0.95f, 0.0f, -0.78f)), -0.32f, glm::vec3(1, 0, 0));
    const uint32_t sheet = add_metal(scene, {"brushed sheet", {0.7f, 0.7f, 0.71f}, 0.3f, 0.85f});
    MeshBuilder builder;
    builder.add_rectangle({-0.95f, 0, 0}, {1.0f, 0, 0}, {0, 1.45f, 0});
    place(scene, builder.finish("sheet"), sheet, leaning);
    const uint32_t star = add_metal(scene, {"star", {0.86f, 0.68f, 0.36f}, 0.3f, 0.85f});
    TextureSlot& grains = scene.materials[star].anisotropy_texture;
    grains.texture = add_star_of_grains(scene);
    grains.mag = grains.min = Filter::nearest;
    grains.mipmapped = false;
    // The mesh's texture coordinates are in metres, so the slot's transform maps the square plate to 0..1.
    constexpr float kSide = 1.25f, kLeft = 0.15f;
    grains.transform = glm::mat3x2{1 / kSide, 0, 0, 1 / kSide, -kLeft / kSide, 1};
    MeshBuilder square;
    square.add_rectangle({kLeft, 0, 0}, {kSide, 0, 0}, {0, kSide, 0});
    place(scene, square.finish("star"), star, leaning);
}

void add_lamps(Scene& scene) {
    const std::array<PointLamp, 4> lamps{{{"lamp 0", {-2.6f, 2.6f, 2.6f}, {1.0f, 0.74f, 0.5f}, 620},
                                          {"lamp 1", {2.8f, 3.0f, 2.4f}, {0.6f, 0.78f, 1.0f}, 620},
                                          {"lamp 2", {0.2f, 3.4f, -0.2f}, {1.0f, 0.95f, 0.88f}, 420},
                                          {"lamp 3", {-0.6f, 1.2f, 4.2f}, {1.0f, 0.9f, 0.8f}, 240}}};
    add_point_lamps(scene, lamps, 14);
}

}  // namespace

Scene make_brushed() {
    Scene scene;
    scene.name = "brushed";
    const uint32_t table = add_matt(scene, "walnut", {0.075f, 0.05f, 0.036f}, 0.45f);
    const uint32_t wall = add_matt(scene, "plaster", {0.34f, 0.36f, 0.37f}, 0.9f);
    add_table_and_wall(scene, {.half_m = 8, .wall_z_m = -1.3f, .table = table, .wall = wall});
    add_pot(scene);
    add_balls(scene);
    add_plates(scene);
    add_lamps(scene);
    Camera camera;
    camera.name = "table";
    camera.transform = glm::inverse(
        glm::lookAt(glm::vec3(0.35f, 2.3f, 5.4f), glm::vec3(0.08f, 0.56f, 0), glm::vec3(0, 1, 0)));
    camera.fov_y_rad = glm::radians(32.0f);
    scene.cameras.push_back(camera);
    finish_scene(scene, glm::vec3(9, 10, 12), glm::vec3(14, 13, 12), -6.2f);
    return scene;
}

}  // namespace weft::scene

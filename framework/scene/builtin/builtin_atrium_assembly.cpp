// Purpose: adds meshes, instances and materials to the scene of the atrium.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "scene/builtin/builtin_atrium_materials.h"

namespace weft::scene::atrium {
namespace {

constexpr float kPlanHalfX = kCourtHalfX + kWalkDepth;
constexpr float kPlanHalfZ = kCourtHalfZ + kWalkDepth;

// Returns the visible fraction of the sky for a point on the floor, without the shadows of objects on the
// floor. The court is open to the sky, the walkway around it is covered.
float open_sky(glm::vec2 p) {
    const float inside = std::min(kCourtHalfX - std::abs(p.x), kCourtHalfZ - std::abs(p.y));
    if (inside > 0) return 0.62f + 0.38f * smooth_step(0.3f, 2.8f, inside);
    return 0.62f - 0.36f * smooth_step(0, 2.6f, -inside);
}

float footprint_factor(const Footprint& footprint, glm::vec2 p) {
    const glm::vec2 away = glm::abs(p - footprint.center);
    const float distance = footprint.round ? glm::length(away) - footprint.half.x
                                           : glm::length(glm::max(away - footprint.half, glm::vec2(0)));
    const float near = 1 - std::clamp(distance / footprint.reach_m, 0.0f, 1.0f);
    return 1 - footprint.strength * near * std::sqrt(near);
}

}  // namespace

uint32_t add_mesh(Parts& parts, Mesh mesh) {
    parts.scene.meshes.push_back(std::move(mesh));
    return static_cast<uint32_t>(parts.scene.meshes.size() - 1);
}

void place_copy(Parts& parts, uint32_t mesh, uint32_t material, const glm::mat4& transform) {
    parts.scene.instances.push_back({parts.scene.meshes[mesh].name, mesh, material, transform});
}

uint32_t place(Parts& parts, Mesh mesh, uint32_t material) {
    const uint32_t index = add_mesh(parts, std::move(mesh));
    place_copy(parts, index, material, glm::mat4(1));
    return index;
}

void add_beam(MeshBuilder& builder, glm::vec3 low, glm::vec3 high) {
    const glm::vec3 size = high - low;
    const glm::vec3 along{size.x, 0, 0};
    const glm::vec3 up{0, size.y, 0};
    const glm::vec3 across{0, 0, size.z};
    builder.add_rectangle({low.x, low.y, high.z}, along, up);
    builder.add_rectangle({high.x, low.y, low.z}, -along, up);
    builder.add_rectangle(low, along, across);
    builder.add_rectangle(low, across, up);
    builder.add_rectangle({high.x, low.y, high.z}, -across, up);
}

glm::mat4 moved(glm::vec3 to, float turn_y_rad, float scale) {
    const glm::mat4 turned = glm::rotate(glm::translate(glm::mat4(1), to), turn_y_rad, glm::vec3(0, 1, 0));
    return glm::scale(turned, glm::vec3(scale));
}

TextureSlot repeating(uint32_t texture, float period_m) {
    TextureSlot slot;
    slot.texture = texture;
    slot.transform = glm::mat3x2(1 / period_m, 0, 0, 1 / period_m, 0, 0);
    return slot;
}

uint32_t add_material(Parts& parts, const std::string& name, const Surface& surface) {
    const SurfaceTextures textures = add_surface(parts.scene, name, surface);
    Material material;
    material.name = name;
    material.base_color_texture = repeating(textures.color, surface.period_m);
    material.metallic_roughness_texture = repeating(textures.metallic_roughness, surface.period_m);
    material.normal_texture = repeating(textures.normal, surface.period_m);
    parts.scene.materials.push_back(std::move(material));
    return static_cast<uint32_t>(parts.scene.materials.size() - 1);
}

uint32_t add_leaf_material(Parts& parts, const std::string& name, const Surface& surface) {
    const SurfaceTextures textures = add_surface(parts.scene, name, surface, true);
    Material material;
    material.name = name;
    material.alpha_mode = AlphaMode::mask;
    material.double_sided = true;
    // Leaves are waxy and so would need a stronger specular reflection. But without shadows, scattered
    // specular light would turn backlit leaves white.
    material.specular = 0.45f;
    material.base_color_texture.texture = textures.color;
    material.metallic_roughness_texture.texture = textures.metallic_roughness;
    material.normal_texture.texture = textures.normal;
    for (TextureSlot* slot :
         {&material.base_color_texture, &material.metallic_roughness_texture, &material.normal_texture}) {
        slot->wrap_u = Wrap::clamp_to_edge;
        slot->wrap_v = Wrap::clamp_to_edge;
    }
    parts.scene.materials.push_back(std::move(material));
    return static_cast<uint32_t>(parts.scene.materials.size() - 1);
}

void shade_by_height(Parts& parts, uint32_t material, const std::vector<float>& values, float low_m,
                     float high_m) {
    // Row 0 is the top of the texture. So row 0 gets the value for the greatest height, which is the last one
    // in `values`.
    constexpr uint32_t kRows = 64;
    std::vector<float> ramp(4 * static_cast<size_t>(kRows));
    for (uint32_t row = 0; row < kRows; ++row) {
        const float t = (1 - (static_cast<float>(row) + 0.5f) / static_cast<float>(kRows)) *
                        static_cast<float>(values.size() - 1);
        const auto index = std::min(static_cast<size_t>(t), values.size() - 2);
        const float fraction = t - static_cast<float>(index);
        const float value = values[index] + (values[index + 1] - values[index]) * fraction;
        for (size_t x = 0; x < 4; ++x) ramp[row * 4 + x] = value;
    }
    const std::string name = parts.scene.materials[material].name + "_occlusion";
    TextureSlot slot;
    slot.texture = add_gray_texture(parts.scene, name, 4, kRows, ramp);
    slot.wrap_u = Wrap::clamp_to_edge;
    slot.wrap_v = Wrap::clamp_to_edge;
    const float span = high_m - low_m;
    // The mesh has v = -height. The transform maps `high_m` to 0 (top of the texture) and `low_m` to 1
    // (bottom).
    slot.transform = glm::mat3x2(1, 0, 0, 1 / span, 0, high_m / span);
    parts.scene.materials[material].occlusion_texture = slot;
}

void bake_floor_occlusion(Parts& parts) {
    constexpr uint32_t kWidth = 384;
    constexpr uint32_t kHeight = 512;
    std::vector<float> plan(static_cast<size_t>(kWidth) * kHeight);
    for (uint32_t y = 0; y < kHeight; ++y) {
        for (uint32_t x = 0; x < kWidth; ++x) {
            const glm::vec2 uv{(static_cast<float>(x) + 0.5f) / kWidth,
                               (static_cast<float>(y) + 0.5f) / kHeight};
            const glm::vec2 p = (uv * 2.0f - 1.0f) * glm::vec2(kPlanHalfX, kPlanHalfZ);
            float value = open_sky(p);
            for (const Footprint& footprint : parts.footprints) value *= footprint_factor(footprint, p);
            plan[static_cast<size_t>(y) * kWidth + x] = value;
        }
    }
    TextureSlot slot;
    slot.texture = add_gray_texture(parts.scene, "floor_plan_occlusion", kWidth, kHeight, plan);
    slot.wrap_u = Wrap::clamp_to_edge;
    slot.wrap_v = Wrap::clamp_to_edge;
    slot.transform = glm::mat3x2(0.5f / kPlanHalfX, 0, 0, 0.5f / kPlanHalfZ, 0.5f, 0.5f);
    for (const uint32_t material :
         {parts.materials.flags, parts.materials.checker, parts.materials.trim_floor}) {
        parts.scene.materials[material].occlusion_texture = slot;
    }
}

}  // namespace weft::scene::atrium

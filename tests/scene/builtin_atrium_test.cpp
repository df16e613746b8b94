// What the default scene promises: enough to look at, at a cost a processor can draw.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "scene/builtin_scenes.h"

namespace weft::scene {
namespace {

Bounds instance_bounds(const Scene& scene, const Instance& instance) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    Bounds bounds{glm::vec3(1e30f), glm::vec3(-1e30f)};
    for (const glm::vec3& position : mesh.positions) {
        const glm::vec3 world(instance.transform * glm::vec4(position, 1));
        bounds.min = glm::min(bounds.min, world);
        bounds.max = glm::max(bounds.max, world);
    }
    return bounds;
}

void expect_triangle_budget(const Scene& scene) {
    size_t triangles = 0;
    for (const Instance& instance : scene.instances)
        triangles += scene.meshes[instance.mesh].indices.size() / 3;
    EXPECT_GE(triangles, 30000u);
    EXPECT_LE(triangles, 50000u);
}

void expect_textured_materials_in_use(const Scene& scene) {
    std::vector<bool> used(scene.materials.size(), false);
    for (const Instance& instance : scene.instances) used[instance.material] = true;
    size_t textured = 0;
    size_t masked = 0;
    for (size_t i = 0; i < scene.materials.size(); ++i) {
        const Material& material = scene.materials[i];
        EXPECT_TRUE(used[i]) << material.name;
        textured += material.base_color_texture.texture != kNone &&
                    material.metallic_roughness_texture.texture != kNone &&
                    material.normal_texture.texture != kNone;
        if (material.alpha_mode != AlphaMode::mask) continue;
        ++masked;
        EXPECT_TRUE(material.double_sided) << material.name;
    }
    EXPECT_GE(textured, 15u);
    EXPECT_GE(masked, 3u);
}

void expect_sun_and_two_dozen_lights(const Scene& scene) {
    size_t suns = 0;
    for (const Light& light : scene.lights) {
        suns += light.type == LightType::directional;
        EXPECT_GT(light.intensity, 0) << light.name;
        EXPECT_NEAR(glm::length(light.direction), 1, 1e-3f) << light.name;
    }
    EXPECT_EQ(suns, 1u);
    EXPECT_GE(scene.lights.size(), 21u);
    EXPECT_LE(scene.lights.size(), 33u);
}

void expect_named_cameras_in_free_space(const Scene& scene) {
    ASSERT_EQ(scene.cameras.size(), 3u);
    EXPECT_EQ(scene.cameras[0].name, "court");
    EXPECT_EQ(scene.cameras[1].name, "gallery");
    EXPECT_EQ(scene.cameras[2].name, "pool");
    for (const Instance& instance : scene.instances) {
        const Bounds bounds = instance_bounds(scene, instance);
        const glm::vec3 size = bounds.max - bounds.min;
        if (std::max({size.x, size.y, size.z}) > 4) continue;  // walls and floors surround the cameras
        for (const Camera& camera : scene.cameras) {
            const glm::vec3 eye(camera.transform[3]);
            const bool inside = glm::all(glm::greaterThan(eye, bounds.min - 0.1f)) &&
                                glm::all(glm::lessThan(eye, bounds.max + 0.1f));
            EXPECT_FALSE(inside) << camera.name << " in " << instance.name;
        }
    }
}

// Texels per metre of a material's normal map over one triangle, from the ratio of areas.
float texel_density(const Mesh& mesh, size_t first, const TextureSlot& slot, const Texture& texture,
                    float* area_m2) {
    const auto position = [&](size_t k) { return mesh.positions[mesh.indices[first + k]]; };
    const auto uv = [&](size_t k) {
        return slot.transform * glm::vec3(mesh.uvs[mesh.indices[first + k]], 1);
    };
    *area_m2 = 0.5f * glm::length(glm::cross(position(1) - position(0), position(2) - position(0)));
    const glm::vec2 a = uv(1) - uv(0);
    const glm::vec2 b = uv(2) - uv(0);
    const float uv_area = 0.5f * std::abs(a.x * b.y - a.y * b.x);
    return std::sqrt(uv_area / *area_m2) * static_cast<float>(texture.width_px);
}

void expect_texels_of_one_order_of_size(const Scene& scene) {
    double area = 0;
    double odd = 0;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        const TextureSlot& slot = scene.materials[instance.material].normal_texture;
        if (slot.texture == kNone) continue;
        for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            float area_m2 = 0;
            const float density = texel_density(mesh, i, slot, scene.textures[slot.texture], &area_m2);
            area += area_m2;
            if (density < 120 || density > 2000) odd += area_m2;
        }
    }
    EXPECT_LT(odd, 0.03 * area);
}

// One test, because making the scene costs more than looking at it.
TEST(BuiltinAtrium, KeepsItsPromises) {
    const Result<Scene> scene = make_builtin("atrium");
    ASSERT_TRUE(scene.ok());
    expect_triangle_budget(*scene);
    expect_textured_materials_in_use(*scene);
    expect_sun_and_two_dozen_lights(*scene);
    expect_named_cameras_in_free_space(*scene);
    expect_texels_of_one_order_of_size(*scene);
}

}  // namespace
}  // namespace weft::scene

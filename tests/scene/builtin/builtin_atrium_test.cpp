// Purpose: tests the default scene "atrium": it must have enough detail, at a cost that a CPU renderer can
// handle.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "scene/builtin/daylight.h"
#include "weft/scene/builtin_scenes.h"

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
    EXPECT_LE(triangles, 58000u);
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

// Checks the sun and the lamps. Some graphs use only the first lights of a scene. By day, these lights must
// be on, so the lamps that are off must come last in the list.
void expect_sun_and_lamps(const Scene& scene, bool night) {
    size_t suns = 0, lit = 0;
    bool still_lit = true;
    for (const Light& light : scene.lights) {
        suns += light.type == LightType::directional;
        lit += light.intensity > 0;
        EXPECT_GE(light.intensity, 0) << light.name;
        EXPECT_NEAR(glm::length(light.direction), 1, 1e-3f) << light.name;
        still_lit = still_lit && light.intensity > 0;
        EXPECT_EQ(light.intensity > 0, still_lit) << light.name;
    }
    EXPECT_EQ(suns, 1u);
    EXPECT_GE(scene.lights.size(), 200u);
    EXPECT_GE(lit, night ? scene.lights.size() : 21u);
    EXPECT_LE(lit, night ? scene.lights.size() : 33u);
}

void expect_water_to_see_through(const Scene& scene) {
    const auto is_clear = [&](const Instance& instance) {
        const Material& material = scene.materials[instance.material];
        return material.alpha_mode == AlphaMode::blend && material.transmission > 0;
    };
    EXPECT_TRUE(std::ranges::any_of(scene.instances, is_clear));
}

void expect_named_cameras_in_free_space(const Scene& scene) {
    ASSERT_EQ(scene.cameras.size(), 3u);
    EXPECT_EQ(scene.cameras[0].name, "court");
    EXPECT_EQ(scene.cameras[1].name, "gallery");
    EXPECT_EQ(scene.cameras[2].name, "pool");
    for (const Instance& instance : scene.instances) {
        const Bounds bounds = instance_bounds(scene, instance);
        const glm::vec3 size = bounds.max - bounds.min;
        if (std::max({size.x, size.y, size.z}) > 4)
            // Skips instances larger than 4 m. They are walls and floors, whose bounds surround the cameras.
            continue;
        for (const Camera& camera : scene.cameras) {
            const glm::vec3 eye(camera.transform[3]);
            const bool inside = glm::all(glm::greaterThan(eye, bounds.min - 0.1f)) &&
                                glm::all(glm::lessThan(eye, bounds.max + 0.1f));
            EXPECT_FALSE(inside) << camera.name << " in " << instance.name;
        }
    }
}

// Returns how many texels per metre a texture has on one triangle: the square root of the triangle's area in
// texels divided by its area in m². The texture is assumed to be square. `first` is the position of the
// triangle's first index in mesh.indices. `area_m2` receives the area.
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

// One test makes all checks, because generating the scene takes longer than the checks.
TEST(BuiltinAtrium, KeepsItsPromises) {
    const Result<Scene> scene = make_builtin("atrium");
    ASSERT_TRUE(scene.ok());
    expect_triangle_budget(*scene);
    expect_textured_materials_in_use(*scene);
    expect_sun_and_lamps(*scene, false);
    expect_water_to_see_through(*scene);
    expect_named_cameras_in_free_space(*scene);
    expect_texels_of_one_order_of_size(*scene);
}

TEST(BuiltinAtrium, LightsItsLampsAtNight) {
    BuiltinOptions options;
    options.hour = 22.0f;
    const Result<Scene> scene = make_builtin("atrium", options);
    ASSERT_TRUE(scene.ok());
    expect_triangle_budget(*scene);
    expect_sun_and_lamps(*scene, true);
}

// The light must change smoothly from minute to minute. At dawn and dusk the light source changes between sun
// and moon, but at these times its illuminance is zero.
TEST(Daylight, GoesByDegrees) {
    for (int minute = 0; minute < 24 * 60; ++minute) {
        const Daylight a = daylight_at(static_cast<float>(minute) / 60),
                       b = daylight_at(static_cast<float>(minute + 1) / 60);
        EXPECT_NEAR(glm::length(a.to_source), 1, 1e-4f);
        EXPECT_GE(a.to_source.y, 0) << minute;
        EXPECT_LT(std::abs(a.exposure_ev - b.exposure_ev), 0.05f) << minute;
        EXPECT_LT(glm::length(a.sky_zenith - b.sky_zenith), 40) << minute;
        const float shown = std::exp2(a.exposure_ev) *
                            glm::length(a.illuminance_lx * a.to_source - b.illuminance_lx * b.to_source);
        EXPECT_LT(shown, 0.2f) << minute;
    }
    EXPECT_EQ(daylight_at(24).illuminance_lx, daylight_at(0).illuminance_lx);
}

TEST(BuiltinLights, MoveWithinTheAtriumAndComeBack) {
    BuiltinOptions options;
    options.lights = 300;
    const Result<Scene> scene = make_builtin("lights", options);
    ASSERT_TRUE(scene.ok());
    ASSERT_EQ(scene->lights.size(), 300u);
    for (const Light& light : scene->lights) {
        ASSERT_NE(light.path.turns_per_s, 0);
        const double period_s = 1 / std::abs(light.path.turns_per_s);
        EXPECT_LT(glm::distance(position_at(light, 0.3), position_at(light, 0.3 + period_s)), 1e-3f);
        for (int i = 0; i < 16; ++i) {
            const glm::vec3 at = position_at(light, i * period_s / 16);
            EXPECT_TRUE(glm::all(glm::greaterThanEqual(at, scene->bounds.min - 1e-3f)));
            EXPECT_TRUE(glm::all(glm::lessThanEqual(at, scene->bounds.max + 1e-3f)));
        }
    }
}

}  // namespace
}  // namespace weft::scene

#include "scene/builtin/builtin_spheres.h"

#include <algorithm>
#include <string>

#include "scene/builtin/scene_parts.h"
#include "scene/procedural/procedural_mesh.h"

namespace weft::scene {
namespace {

constexpr uint32_t kSide = 7;
constexpr float kSpacing = 1.0f;
constexpr float kRadius = 0.42f;

uint32_t add_sphere_material(Scene& scene, uint32_t column, uint32_t row) {
    const float last = static_cast<float>(kSide - 1);
    Material material;
    material.roughness = std::max(0.05f, static_cast<float>(column) / last);
    material.metallic = static_cast<float>(row) / last;
    material.base_color = glm::vec4(0.78f, 0.30f, 0.16f, 1);
    material.name = "roughness_" + std::to_string(column) + "_metalness_" + std::to_string(row);
    scene.materials.push_back(std::move(material));
    return static_cast<uint32_t>(scene.materials.size() - 1);
}

void add_ground(Scene& scene) {
    constexpr float kHalf = 14;
    MeshBuilder builder;
    builder.add_rectangle({-kHalf, 0, kHalf}, {2 * kHalf, 0, 0}, {0, 0, -2 * kHalf});
    scene.meshes.push_back(builder.finish("ground"));
    Material ground;
    ground.name = "ground";
    ground.base_color = glm::vec4(0.18f, 0.19f, 0.21f, 1);
    ground.metallic = 0;
    ground.roughness = 0.85f;
    scene.materials.push_back(ground);
    scene.instances.push_back({"ground", static_cast<uint32_t>(scene.meshes.size() - 1),
                               static_cast<uint32_t>(scene.materials.size() - 1), glm::mat4(1)});
}

Camera overview() {
    const glm::vec3 eye{0, 9.2f, 7.0f};
    const glm::vec3 back = glm::normalize(eye - glm::vec3(0, 0.1f, 0.15f));
    const glm::vec3 right{1, 0, 0};
    Camera camera;
    camera.name = "overview";
    camera.transform = glm::mat4(glm::vec4(right, 0), glm::vec4(glm::cross(back, right), 0),
                                 glm::vec4(back, 0), glm::vec4(eye, 1));
    camera.fov_y_rad = 0.58f;
    return camera;
}

}  // namespace

Scene make_spheres() {
    Scene scene;
    scene.name = "spheres";
    MeshBuilder builder;
    builder.add_sphere({0, 0, 0}, kRadius, 32, 16);
    scene.meshes.push_back(builder.finish("sphere"));
    for (uint32_t row = 0; row < kSide; ++row) {
        for (uint32_t column = 0; column < kSide; ++column) {
            const uint32_t material = add_sphere_material(scene, column, row);
            const float half = 0.5f * static_cast<float>(kSide - 1);
            const glm::vec3 at{(static_cast<float>(column) - half) * kSpacing, kRadius,
                               (half - static_cast<float>(row)) * kSpacing};
            glm::mat4 transform(1);
            transform[3] = glm::vec4(at, 1);
            scene.instances.push_back({scene.materials[material].name, 0, material, transform});
        }
    }
    add_ground(scene);
    Light lamp;
    lamp.name = "lamp";
    lamp.type = LightType::point;
    lamp.intensity = 90000;
    lamp.position = {-3.5f, 5.5f, 4.5f};
    scene.lights.push_back(lamp);
    scene.cameras.push_back(overview());
    finish_scene(scene, glm::vec3(70, 105, 170), glm::vec3(210, 225, 240), -9.6f);
    return scene;
}

}  // namespace weft::scene

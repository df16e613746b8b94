#include "scene/builtin/scene_parts.h"

#include <string>
#include <utility>

#include "scene/procedural/procedural_mesh.h"

namespace weft::scene {

uint32_t add_matt(Scene& scene, const char* name, glm::vec3 color, float roughness) {
    Material material;
    material.name = name;
    material.base_color = glm::vec4(color, 1);
    material.metallic = 0;
    material.roughness = roughness;
    scene.materials.push_back(std::move(material));
    return static_cast<uint32_t>(scene.materials.size() - 1);
}

void place(Scene& scene, Mesh mesh, uint32_t material, const glm::mat4& transform) {
    const std::string name = mesh.name;
    scene.meshes.push_back(std::move(mesh));
    scene.instances.push_back({name, static_cast<uint32_t>(scene.meshes.size() - 1), material, transform});
}

uint32_t add_material(Scene& scene, Material material) {
    scene.materials.push_back(std::move(material));
    return static_cast<uint32_t>(scene.materials.size() - 1);
}

void add_table_and_wall(Scene& scene, const TableAndWall& shape) {
    const float half = shape.half_m, wall_z = shape.wall_z_m;
    MeshBuilder table;
    table.add_rectangle({-half, 0, half}, {2 * half, 0, 0}, {0, 0, wall_z - half});
    place(scene, table.finish("table"), shape.table);
    MeshBuilder wall;
    wall.add_rectangle({-half, 0, wall_z}, {2 * half, 0, 0}, {0, half, 0});
    place(scene, wall.finish("wall"), shape.wall);
}

void add_point_lamps(Scene& scene, std::span<const PointLamp> lamps, float range_m) {
    for (const PointLamp& lamp : lamps) {
        Light light;
        light.name = lamp.name;
        light.color = lamp.color;
        light.intensity = lamp.intensity_cd;
        light.position = lamp.position;
        light.range_m = range_m;
        scene.lights.push_back(std::move(light));
    }
}

void finish_scene(Scene& scene, glm::vec3 sky_zenith, glm::vec3 sky_horizon, float exposure_ev) {
    scene.sky_zenith = sky_zenith;
    scene.sky_horizon = sky_horizon;
    scene.exposure_ev = exposure_ev;
    scene.bounds = world_bounds(scene);
}

}  // namespace weft::scene

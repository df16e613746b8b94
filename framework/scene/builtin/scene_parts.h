// Purpose: adds plain meshes and materials to scenes that are made in code.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "weft/scene/scene.h"

namespace weft::scene {

// Adds a non-metallic material of one colour. Returns the index of the material.
uint32_t add_matt(Scene& scene, const char* name, glm::vec3 color, float roughness = 1);
// Adds the mesh and one instance of the mesh. The instance gets the name of the mesh.
void place(Scene& scene, Mesh mesh, uint32_t material, const glm::mat4& transform = glm::mat4(1));

// Adds a material. Returns its index.
uint32_t add_material(Scene& scene, Material material);

// A table from z = half_m to the wall, and a wall behind it that is half_m high. Both are 2 · half_m wide.
struct TableAndWall {
    float half_m, wall_z_m;
    uint32_t table, wall;  // Materials.
};
void add_table_and_wall(Scene& scene, const TableAndWall& shape);

struct PointLamp {
    const char* name;
    glm::vec3 position, color;
    float intensity_cd;
};
// Adds point lights whose light ends at the distance `range_m`.
void add_point_lamps(Scene& scene, std::span<const PointLamp> lamps, float range_m);

// Completes a scene: sets the sky's colours in cd/m², the exposure in EV, and the bounds of all instances.
void finish_scene(Scene& scene, glm::vec3 sky_zenith, glm::vec3 sky_horizon, float exposure_ev);

}  // namespace weft::scene

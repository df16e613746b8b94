// Purpose: data and functions for the files that build the atrium: dimensions, materials, unfinished scene.
// Axes: y is up, the long side of the court runs along z, and the origin is in the middle of the court.
// Units: metres. Layout: the court is open to the sky; a walkway runs around it behind an arcade. The long
// sides (x = ±6) have an upper gallery with a tiled roof, the short sides (z = ±9) a terrace with a
// balustrade.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scene/builtin/daylight.h"
#include "scene/procedural/procedural_mesh.h"
#include "scene/procedural/procedural_noise.h"
#include "weft/scene/scene.h"

namespace weft::scene::atrium {

// Distance from the origin to the centre line of the arcade on a long side, in metres.
inline constexpr float kCourtHalfX = 6;
inline constexpr float kCourtHalfZ = 9;
inline constexpr float kBay = 3;  // Distance between two neighbouring columns, in metres.
// Width of the walkway in metres, from the centre line of the arcade to the outer wall.
inline constexpr float kWalkDepth = 3.2f;
// Height of the walkway's floor in metres. It lies one step above the court, whose floor has height 0.
inline constexpr float kFloor = 0.16f;
inline constexpr float kSpring = 3.06f;  // Height at which the arches start on top of the columns, in metres.
inline constexpr float kArchRadius = 1.2f;
inline constexpr float kArchOuter = 1.43f;
inline constexpr float kWallHalf = 0.28f;  // Half of the thickness of the arcade's wall, in metres.
inline constexpr float kWallTop = 4.62f;
inline constexpr float kUpperFloor = 5.0f;
inline constexpr float kCeiling = 4.56f;
inline constexpr float kEaves = 7.9f;
// Distance from the origin to the outside of the pool's rim along x, in metres.
inline constexpr float kPoolHalfX = 1.75f;
inline constexpr float kPoolHalfZ = 4.0f;
inline constexpr float kPoolRim = 0.42f;
inline constexpr float kWaterDepth = 0.26f;

struct Materials {
    uint32_t ashlar, trim, trim_shaded, trim_floor, coping, voussoir, marble, checker, inlay, flags, azulejo,
        zellige;
    uint32_t plaster_red, plaster_ochre, water, beam, planks, door, clay, roof;
    uint32_t bronze, gold, steel, iron, glass, bulb;
    uint32_t cloth_red, cloth_saffron, cloth_indigo;
    uint32_t bark, soil, citrus, ivy, fern, blossom, cypress, lily, orange;
};

// The outline of an object on the floor. The object blocks light from the sky, so it darkens the floor around
// it.
struct Footprint {
    glm::vec2 center{0};  // Centre of the object as (x, z) in metres.
    // Half of the object's extent along x and z, in metres. For a round object, half.x is the radius.
    glm::vec2 half{0.2f};
    bool round = true;
    float reach_m = 0.35f;  // Distance from the object at which its darkening of the floor ends, in metres.
    float strength = 0.6f;  // Share of the sky's light that the object blocks at its outline.
};

struct Parts {
    Scene scene;
    Daylight daylight;
    NoiseBank noise;
    Materials materials{};
    std::vector<Footprint> footprints;
};

// Functions that make the textures and materials of the atrium, one function per group of materials.
void make_stone_materials(Parts& parts);
void make_tile_materials(Parts& parts);
void make_craft_materials(Parts& parts);
void make_metal_materials(Parts& parts);
void make_foliage_materials(Parts& parts);

// Functions that add the geometry of the atrium, one function per part of the building or group of objects.
void add_ground_floor(Parts& parts);
void add_arcades(Parts& parts);
void add_columns(Parts& parts);
void add_upper_gallery(Parts& parts);
void add_terraces(Parts& parts);
void add_pool(Parts& parts);
void add_fountain(Parts& parts);
void add_cloth(Parts& parts);
void add_furniture(Parts& parts);
void add_table(Parts& parts);
void add_armillary(Parts& parts);
void add_plants(Parts& parts);
void add_climbers(Parts& parts);
void add_lanterns(Parts& parts);
void add_lights(Parts& parts);
void add_garlands(Parts& parts);
void add_candles(Parts& parts);
void add_cameras(Parts& parts);
void bake_floor_occlusion(Parts& parts);

// Adds the mesh and one instance of the mesh. Returns the index of the mesh.
uint32_t place(Parts& parts, Mesh mesh, uint32_t material);
uint32_t add_mesh(Parts& parts, Mesh mesh);
void place_copy(Parts& parts, uint32_t mesh, uint32_t material, const glm::mat4& transform);

// Adds a beam along x without its top face: two sides, the underside and both ends.
void add_beam(MeshBuilder& builder, glm::vec3 low, glm::vec3 high);

[[nodiscard]] glm::mat4 moved(glm::vec3 to, float turn_y_rad = 0, float scale = 1);

// Returns a texture slot whose texture repeats every `period_m` metres. The mesh's texture coordinates are in
// metres.
[[nodiscard]] TextureSlot repeating(uint32_t texture, float period_m);

}  // namespace weft::scene::atrium

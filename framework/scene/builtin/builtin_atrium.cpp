#include "scene/builtin/builtin_atrium.h"

#include <utility>

#include "scene/builtin/builtin_atrium_materials.h"

namespace weft::scene {

Scene make_atrium(float hour) {
    atrium::Parts parts;
    parts.daylight = daylight_at(hour);
    parts.scene.name = "atrium";
    parts.noise = make_noise_bank(atrium::kTextureSize);
    make_stone_materials(parts);
    make_tile_materials(parts);
    make_craft_materials(parts);
    make_metal_materials(parts);
    make_foliage_materials(parts);

    add_ground_floor(parts);
    add_arcades(parts);
    add_columns(parts);
    add_upper_gallery(parts);
    add_terraces(parts);
    add_pool(parts);
    add_fountain(parts);
    add_cloth(parts);
    add_furniture(parts);
    add_table(parts);
    add_armillary(parts);
    add_plants(parts);
    add_climbers(parts);
    add_lanterns(parts);
    add_lights(parts);
    add_garlands(parts);
    add_candles(parts);
    add_cameras(parts);
    bake_floor_occlusion(parts);

    parts.scene.bounds = world_bounds(parts.scene);
    return std::move(parts.scene);
}

}  // namespace weft::scene

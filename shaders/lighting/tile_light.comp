// Deferred lighting of the tiles of one class, with one workgroup per tile in the class's list. The constant TILE_CLASS
// removes the features that the class does not need.
#version 460
layout(local_size_x = 16, local_size_y = 16) in;

#include "tile_class.glsl"

layout(constant_id = 0) const uint TILE_CLASS = 3u;
const bool AREA_LIGHTS = TILE_CLASS == kTileAny;
#define AREA_LIGHTS AREA_LIGHTS
const bool LIGHT_FUNCTIONS = TILE_CLASS == kTileAny;
#define LIGHT_FUNCTIONS LIGHT_FUNCTIONS

#include "gbuffer_light.glsl"

layout(std430) readonly buffer Tiles { uint items[]; } tiles;

void main() {
    const uint tile = tiles.items[kTilesBegin + gl_WorkGroupID.x];
    const uint columns = uint(tile_count().x);
    const ivec2 pixel = ivec2(uvec2(tile % columns, tile / columns) * gl_WorkGroupSize.xy + gl_LocalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(hdr)))) return;
    if (TILE_CLASS == kTileSky) {
        store_light(pixel, sky_light((vec2(pixel) + 0.5) / vec2(imageSize(hdr))));
    } else {
        light_pixel(pixel);
    }
}

// Which lights reach which tile: the lists that light culling writes. Tiles are 16 × 16 pixels, in rows from the top left;
// the last ones of a row or column may hang over. A list is its length and then indices into the list of all lights,
// ascending, without the directional ones. The buffer port is `tileLights`.
#ifndef WEFT_TILE_LIGHTS
#define WEFT_TILE_LIGHTS
#include "frame_set.glsl"

layout(std430) readonly buffer TileLights { uint items[]; } tileLights;

const int kTileSizeLog2 = 4;

ivec2 tile_count() { return (ivec2(view.viewport_px) + (1 << kTileSizeLog2) - 1) >> kTileSizeLog2; }

// Where the list of the tile that a pixel lies in begins.
uint tile_list(ivec2 pixel) {
    const ivec2 tiles = tile_count();
    const ivec2 tile = pixel >> kTileSizeLog2;
    return uint(tile.y * tiles.x + tile.x) * (uint(tileLights.items.length()) / uint(tiles.x * tiles.y));
}
#endif

// Light lists per tile, as written by light culling. Tiles are 16 × 16 pixels, in rows from the top left; the
// last ones of a row or column may extend beyond the picture. A list is its length followed by ascending
// indices into the list of all lights, without directional lights. The buffer port is `tileLights`.
#ifndef WEFT_TILE_LIGHTS
#define WEFT_TILE_LIGHTS
#include "frame_set.glsl"

layout(std430) readonly buffer TileLights { uint items[]; } tileLights;

const int kTileSizeLog2 = 4;

ivec2 tile_count() { return (ivec2(view.viewport_px) + (1 << kTileSizeLog2) - 1) >> kTileSizeLog2; }

// Start of the list of the tile that contains a pixel.
uint tile_list(ivec2 pixel) {
    const ivec2 tiles = tile_count();
    const ivec2 tile = pixel >> kTileSizeLog2;
    return uint(tile.y * tiles.x + tile.x) * (uint(tileLights.items.length()) / uint(tiles.x * tiles.y));
}
#endif

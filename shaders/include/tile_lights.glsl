// Reads the lists of lights per tile, which light culling writes to the buffer port `tileLights`. Tiles have 16 × 16
// pixels and are stored in rows from the top left; the last tiles may extend beyond the picture. A list is its length,
// followed by ascending indices into the buffer of all lights. Directional lights are not in the lists.
#ifndef WEFT_TILE_LIGHTS
#define WEFT_TILE_LIGHTS
#include "frame_set.glsl"

layout(std430) readonly buffer TileLights { uint items[]; } tileLights;

const int kTileSizeLog2 = 4;

ivec2 tile_count() { return (ivec2(view.viewport_px) + (1 << kTileSizeLog2) - 1) >> kTileSizeLog2; }

// Returns where the list of the tile that contains the pixel starts in the buffer.
uint tile_list(ivec2 pixel) {
    const ivec2 tiles = tile_count();
    const ivec2 tile = pixel >> kTileSizeLog2;
    return uint(tile.y * tiles.x + tile.x) * (uint(tileLights.items.length()) / uint(tiles.x * tiles.y));
}
#endif

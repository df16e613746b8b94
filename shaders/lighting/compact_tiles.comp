// Writes the list of tiles of each class. Each list starts with the size of its indirect dispatch. There is
// one workgroup. Each invocation counts the classes in a consecutive range of tiles. From the prefix sum of
// the counts, the invocation gets its start position in each list, and writes its tiles there. No atomics are
// used, so the lists are in order and equal in every run.
#version 460
layout(local_size_x = 256) in;

#include "frame_set.glsl"
#include "prefix_sum.glsl"
#include "tile_class.glsl"

uniform usampler2D tileClass;
layout(std430) writeonly buffer SkyTiles { uint items[]; } skyTiles;
layout(std430) writeonly buffer DirectionalTiles { uint items[]; } directionalTiles;
layout(std430) writeonly buffer PunctualTiles { uint items[]; } punctualTiles;
layout(std430) writeonly buffer AnyTiles { uint items[]; } anyTiles;

uint class_at(uint tile, uint columns) { return texelFetch(tileClass, ivec2(tile % columns, tile / columns), 0).r; }

uvec4 one_of(uint tile_class) {
    return uvec4(equal(uvec4(tile_class), uvec4(kTileSky, kTileDirectional, kTilePunctual, kTileAny)));
}

void append(uint tile_class, uvec4 at, uint tile) {
    if (tile_class == kTileSky) skyTiles.items[kTilesBegin + at.x] = tile;
    if (tile_class == kTileDirectional) directionalTiles.items[kTilesBegin + at.y] = tile;
    if (tile_class == kTilePunctual) punctualTiles.items[kTilesBegin + at.z] = tile;
    if (tile_class == kTileAny) anyTiles.items[kTilesBegin + at.w] = tile;
}

void write_sizes(uvec4 tiles) {
    for (uint i = 0u; i < 3u; ++i) {
        skyTiles.items[i] = i == 0u ? tiles.x : 1u;
        directionalTiles.items[i] = i == 0u ? tiles.y : 1u;
        punctualTiles.items[i] = i == 0u ? tiles.z : 1u;
        anyTiles.items[i] = i == 0u ? tiles.w : 1u;
    }
}

void main() {
    const uint me = gl_LocalInvocationIndex;
    const uvec2 size = uvec2(textureSize(tileClass, 0));
    const uint run = (size.x * size.y + gl_WorkGroupSize.x - 1u) / gl_WorkGroupSize.x;
    const uint first = min(me * run, size.x * size.y), end = min(first + run, size.x * size.y);
    uvec4 own = uvec4(0u);
    for (uint tile = first; tile < end; ++tile) own += one_of(class_at(tile, size.x));
    counts[me] = own;  // Components: the classes sky, directional, punctual and any.
    sum_counts(me);
    uvec4 at = counts[me] - own;
    for (uint tile = first; tile < end; ++tile) {
        const uint tile_class = class_at(tile, size.x);
        append(tile_class, at, tile);
        at += one_of(tile_class);
    }
    if (me == gl_WorkGroupSize.x - 1u) write_sizes(counts[me]);
}

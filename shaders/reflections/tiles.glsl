// Tiles of 8 × 8 texels of the reflections. The passes that trace, filter and blend run only for tiles with a texel that
// reflects.
#ifndef WEFT_REFLECTION_TILES
#define WEFT_REFLECTION_TILES

const uint kTileSide = 8u;
// Replaces the roughness of a surface without rays.
const float kNoRays = 2.0;
// Layout of a list of tiles. Words 0 to 2: workgroup counts x, y, z of the indirect dispatch; at most kMostGroups in each
// row, the number that every device allows. Word 3: the number of tiles. From word kTilesBegin on: the tiles, numbered row
// by row from 0.
const uint kTilesBegin = 4u, kMostGroups = 65535u;

// Returns the texel of this invocation in a tile. `size`: of the image, in texels.
ivec2 texel_of_tile(uint tile, ivec2 size) {
    const uint columns = (uint(size.x) + kTileSide - 1u) / kTileSide;
    return ivec2(uvec2(tile % columns, tile / columns) * kTileSide + gl_LocalInvocationID.xy);
}

// Returns the number of this workgroup in its list. The last row of workgroups may be longer than the list.
uint place_in_list() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }
#endif

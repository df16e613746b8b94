// Writes two lists of tiles: those with a texel that reflects, and the others; see tiles.glsl. There is one workgroup.
// Each invocation reads a consecutive range of tiles.
#version 460
layout(local_size_x = 256) in;

#include "prefix_sum.glsl"
#include "tiles.glsl"

uniform usampler2D ssrTileClass;
layout(std430) writeonly buffer Listed { uint items[]; } ssrListed;
layout(std430) writeonly buffer Others { uint items[]; } ssrOthers;

bool reflects(uint tile, uint columns) {
    return texelFetch(ssrTileClass, ivec2(tile % columns, tile / columns), 0).r != 0u;
}

void main() {
    const uint me = gl_LocalInvocationIndex;
    const uvec2 size = uvec2(textureSize(ssrTileClass, 0));
    const uint run = (size.x * size.y + gl_WorkGroupSize.x - 1u) / gl_WorkGroupSize.x;
    const uint first = min(me * run, size.x * size.y), end = min(first + run, size.x * size.y);
    uint own = 0u;
    for (uint tile = first; tile < end; ++tile) own += uint(reflects(tile, size.x));
    counts[me] = uvec4(own, 0u, 0u, 0u);
    sum_counts(me);
    uint listed = counts[me].x - own;
    for (uint tile = first; tile < end; ++tile) {
        if (reflects(tile, size.x)) {
            ssrListed.items[kTilesBegin + listed] = tile;
            ++listed;
        } else {
            ssrOthers.items[kTilesBegin + tile - listed] = tile;
        }
    }
    if (me != gl_WorkGroupSize.x - 1u) return;
    for (uint i = 0u; i < kTilesBegin; ++i) {
        ssrListed.items[i] = i == 0u ? listed : 1u;
        ssrOthers.items[i] = i == 0u ? size.x * size.y - listed : 1u;
    }
}

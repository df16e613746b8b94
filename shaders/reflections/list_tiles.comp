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
    const uint others = size.x * size.y - listed;
    const uint sizes[] = uint[](min(listed, kMostGroups), (listed + kMostGroups - 1u) / kMostGroups, 1u, listed);
    const uint other_sizes[] = uint[](min(others, kMostGroups), (others + kMostGroups - 1u) / kMostGroups, 1u, others);
    for (uint i = 0u; i < kTilesBegin; ++i) {
        ssrListed.items[i] = sizes[i];
        ssrOthers.items[i] = other_sizes[i];
    }
}

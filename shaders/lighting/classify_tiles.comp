// Determines the class of each tile (see tile_class.glsl) from three inputs: whether the tile has a surface, the lights
// in its list, and the directional lights, which are in no list.
#version 460
layout(local_size_x = 8, local_size_y = 8) in;

#include "frame_set.glsl"
#include "shared/light.glsl"
#include "tile_class.glsl"

uniform sampler2D hiz;  // The mip that has one texel per tile; r is 0 if the tile has no surface.
layout(std430) readonly buffer Lights { Light items[]; } lights;
layout(r32ui) writeonly uniform uimage2D tileClass;

#include "tile_lights.glsl"

bool needs_more(uint light) { return lights.items[light].type >= kLightCapsule || lights.items[light].function != 0u; }

uint class_of(ivec2 tile) {
    if (texelFetch(hiz, tile, 0).r <= 0.0) return kTileSky;
    const uint directional = min(frame.directional_count, uint(lights.items.length()));
    for (uint i = 0u; i < directional; ++i)
        if (needs_more(i)) return kTileAny;
    const uint list = tile_list(tile << kTileSizeLog2);
    const uint listed = tileLights.items[list];
    for (uint i = 0u; i < listed; ++i)
        if (needs_more(tileLights.items[list + 1u + i])) return kTileAny;
    return listed == 0u ? kTileDirectional : kTilePunctual;
}

void main() {
    const ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(tile, tile_count()))) return;
    imageStore(tileClass, tile, uvec4(class_of(tile)));
}

// The lights that may reach a tile of 16 × 16 pixels, a workgroup each: those of its super-tile that reach a box around one
// of the tile's slices. The span from its nearest to its farthest pixel is cut into 32 slices of equal depth; a slice's box
// is as wide as the pixels in it. After Harada's 2.5D culling (SIGGRAPH Asia 2012), which has one bit where there is a box
// here.
// in   depth         reversed; the sky is 0 and reached by nothing
//      hiz           near and far of each tile, see hiz/hiz.comp
//      lights, superLights  see super_tiles.comp
//      glassDepth    with TRANSLUCENT: the nearest transparent surface; pixels then reach from it to the opaque surface, or
//                    without end where there is none
// out  tileLights    for each tile, in rows, a length and the lights' indices, ascending
//      tileOverflow  grows by what lists have no room for: lights, lists; and the longest list that was wanted
//      tileMask      optional: the same sets, without a limit, as a bit for each light
#version 460
#include "frame_set.glsl"
#include "pixel_box.glsl"
#include "shared/light.glsl"
#include "reach.glsl"

layout(constant_id = 0) const bool HAS_glassDepth = false;
layout(constant_id = 1) const bool HAS_tileMask = false;
layout(constant_id = 2) const bool TRANSLUCENT = false;

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D depth, hiz, glassDepth;
readonly buffer Lights { Light items[]; } lights;
readonly buffer SuperLights { uint items[]; } superLights;
writeonly buffer TileLights { uint items[]; } tileLights;
buffer TileOverflow { uint left_out, lists, longest; } tileOverflow;
coherent buffer TileMask { uint items[]; } tileMask;

const int kThreads = 64;
#define CHUNK 64
#include "sorted_list.glsl"
#include "tile_slices.glsl"

uint tile_index() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }
uint tile_total() { return gl_NumWorkGroups.x * gl_NumWorkGroups.y; }

uint super_list() {
    const uvec2 super = gl_WorkGroupID.xy >> 3, supers = (gl_NumWorkGroups.xy + 7u) >> 3;
    return (super.y * supers.x + super.x) * (uint(superLights.items.length()) / (supers.x * supers.y));
}

void count_overflow(uint listed, uint room) {
    if (listed <= room) return;
    atomicAdd(tileOverflow.left_out, listed - room);
    atomicAdd(tileOverflow.lists, 1u);
    atomicMax(tileOverflow.longest, listed);
}

void main() {
    const uint stride = uint(tileLights.items.length()) / tile_total(), list = tile_index() * stride;
    const uint mask_words = HAS_tileMask ? uint(tileMask.items.length()) / tile_total() : 0u;
    for (uint i = gl_LocalInvocationIndex; i < mask_words; i += kThreads) tileMask.items[tile_index() * mask_words + i] = 0u;
    uint listed = 0u;
    if (find_slices()) {
        if (HAS_tileMask) memoryBarrierBuffer();
        begin_list();
        vec3 planes[4];
        side_planes(tile_slopes(), planes);
        const uint candidates = super_list(), count = superLights.items[candidates];
        for (uint base = 0u; base < count; base += CHUNK) {
            const uint at = base + gl_LocalInvocationIndex;
            uint index = 0u;
            bool kept = false;
            if (at < count) {
                index = superLights.items[candidates + 1u + at];
                const Reach r = reach_of(lights.items[index]);
                kept = !outside(r, planes) && reaches_slice(r);
            }
            const uint place = listed_before(kept, listed);
            if (!kept) continue;
            if (place + 1u < stride) tileLights.items[list + 1u + place] = index;
            if (HAS_tileMask) atomicOr(tileMask.items[tile_index() * mask_words + index / 32u], 1u << (index % 32u));
        }
    }
    if (gl_LocalInvocationIndex != 0u) return;
    tileLights.items[list] = min(listed, stride - 1u);
    count_overflow(listed, stride - 1u);
}

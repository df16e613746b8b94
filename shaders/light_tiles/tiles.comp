// Lists the lights that may reach a tile of 16 × 16 pixels, with one workgroup per tile. The depth range of the tile's
// pixels is divided into 32 slices of equal thickness. Each slice has a box around the pixels in it. A light of the
// super-tile is listed if it reaches one of these boxes. Harada's 2.5D culling (SIGGRAPH Asia 2012) is similar, but has
// a bit instead of a box for each slice. Cheap tests come first: columns, rows and a sphere around the light
// (super_list.glsl). Only the remaining lights are tested exactly, and they are distributed so that all threads have
// work.
// Input depth: reversed; 0 is the sky, which no light reaches. Input hiz: nearest and farthest depth of each tile
// (hiz/hiz.comp). Input lightBounds, superLights: see light_bounds.comp, super_tiles.comp. Input glassDepth, with
// TRANSLUCENT: the nearest transparent surface. A pixel then covers the range from this surface to the opaque surface,
// or to infinity if there is no opaque surface.
// Output tileLights: for each tile, row by row, the number of its lights and their indices, ascending. Output
// tileOverflow: number of lights that did not fit into their lists; number of lists that were too short; the length
// that the longest of these lists would need. Output tileMask, optional: the same sets of lights without a limit, with
// one bit per light.
#version 460
#include "frame_set.glsl"
#include "light_bounds.glsl"
#include "pixel_box.glsl"
#include "reach.glsl"
#include "sorted_list.glsl"
#include "super_list.glsl"

layout(constant_id = 0) const bool HAS_glassDepth = false;
layout(constant_id = 1) const bool HAS_tileMask = false;
layout(constant_id = 2) const bool TRANSLUCENT = false;

layout(local_size_x = 32) in;

uniform sampler2D depth, hiz, glassDepth, lightBounds;
readonly buffer SuperLights { uvec2 items[]; } superLights;
writeonly buffer TileLights { uint items[]; } tileLights;
buffer TileOverflow { uint overflowed, lists, longest; } tileOverflow;
coherent buffer TileMask { uint items[]; } tileMask;

#include "bounds_of_light.glsl"
#include "tile_slices.glsl"

uint list, room;  // Start of the tile's list, and the number of lights that fit into it.

uint tile_index() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }
uint tile_total() { return gl_NumWorkGroups.x * gl_NumWorkGroups.y; }
uint mask_words() { return uint(tileMask.items.length()) / tile_total(); }

uint super_list() {
    const uvec2 super = gl_WorkGroupID.xy >> 3, supers = (gl_NumWorkGroups.xy + 7u) >> 3;
    return (super.y * supers.x + super.x) * (uint(superLights.items.length()) / (supers.x * supers.y));
}

uint slices_of_entry(uvec2 entry, TileBounds bounds) {
    return slices_at(sphere_of(light_of(entry)), near_of(entry), far_of(entry), bounds);
}

// Each thread tests four entries of the super-tile's list, from `first` on. The set bits of the result mark the entries
// of this thread that may reach the tile.
uint find_candidates(uint first, uint end, TileBounds bounds) {
    const uvec2 tile = gl_WorkGroupID.xy % uint(kTilesPerSide);
    const uint own = first + kPerThread * gl_LocalInvocationIndex;
    uint found = 0u;
    for (uint i = 0u; i < kPerThread; ++i) {
        const uvec2 entry = superLights.items[min(own + i, end - 1u)];
        if (own + i < end && holds_tile(entry, tile) && slices_of_entry(entry, bounds) != 0u) found |= 1u << i;
    }
    return found;
}

void put(uint light, uint place) {
    if (place < room) tileLights.items[list + 1u + place] = light;
    if (HAS_tileMask) atomicOr(tileMask.items[tile_index() * mask_words() + light / 32u], 1u << (light % 32u));
}

uint fill_list() {
    find_edges();  // find_edges() needs a barrier after it; the first round contains this barrier.
    const TileBounds bounds = tile_bounds();
    // `end` is at least 1, so `end` − 1 is valid.
    const uint super = super_list(), end = super + 1u + superLights.items[super].x;
    uint listed = 0u;
    for (uint first = super + 1u;;) {
        const uint slot = enter_some(find_candidates(first, end, bounds)), count = entered_count(slot);
        for (uint i = 0u;;) {
            const uint at = i + gl_LocalInvocationIndex;
            const uvec2 entry = superLights.items[min(first + entered_after(slot, min(at, max(count, 1u) - 1u)), end - 1u)];
            const uint light = light_of(entry);
            const uint slices = at < count ? slices_of_entry(entry, bounds) : 0u;
            const bool kept = reaches_slice(sphere_of(light), reach_of(light), slices);
            uint entered;
            const uint place = enter_one(kept, entered);
            if (kept) put(light, listed + place);
            listed += entered;
            i += kThreads;
            if (i >= count) break;
        }
        first += kRound;
        if (first >= end) break;
    }
    return listed;
}

void clear_mask() {
    if (!HAS_tileMask) return;
    for (uint i = gl_LocalInvocationIndex; i < mask_words(); i += kThreads) tileMask.items[tile_index() * mask_words() + i] = 0u;
    memoryBarrierBuffer();
}

void main() {
    clear_mask();
    room = uint(tileLights.items.length()) / tile_total() - 1u;
    list = tile_index() * (room + 1u);
    const uint listed = find_slices() ? fill_list() : 0u;
    if (gl_LocalInvocationIndex != 0u) return;
    tileLights.items[list] = min(listed, room);
    if (listed <= room) return;
    atomicAdd(tileOverflow.overflowed, listed - room);
    atomicAdd(tileOverflow.lists, 1u);
    atomicMax(tileOverflow.longest, listed);
}

// Lists the lights that may reach a super-tile, a square of 128 × 128 pixels. One workgroup per super-tile
// tests all lights, so that each tile needs to test only a few. If the bounding sphere of a light meets the
// super-tile, the exact shape of the light is tested against the side planes of all columns and rows of
// tiles.
// Input hiz: nearest and farthest depth of each super-tile (hiz/hiz.comp). Input glassHiz, optional: the
// same for transparent surfaces; anything behind these may be visible. Input lightBounds: see
// light_bounds.comp.
// Output superLights: for each super-tile, row by row, the number of its lights and one entry per light, in
// ascending order (super_list.glsl). Each list has room for all lights.
#version 460
#include "frame_set.glsl"
#include "light_bounds.glsl"
#include "pixel_box.glsl"
#include "reach.glsl"
#include "sorted_list.glsl"
#include "super_list.glsl"

layout(constant_id = 0) const bool HAS_glassHiz = false;

layout(local_size_x = 32) in;

uniform sampler2D hiz, glassHiz, lightBounds;
writeonly buffer SuperLights { uvec2 items[]; } superLights;

#include "bounds_of_light.glsl"

// Normals of planes through the eye, pointing inwards. For each column of tiles: x and z of the left plane, then of the
// right plane. For each row of tiles: y and z of the lower plane, then of the upper plane.
shared vec4 column_sides[kTilesPerSide], row_sides[kTilesPerSide];

uint list_stride() { return uint(superLights.items.length()) / (gl_NumWorkGroups.x * gl_NumWorkGroups.y); }

// Finds the range of distances of the super-tile's surfaces. Returns false if the super-tile shows only sky.
bool find_range(out float near_m, out float far_m) {
    const ivec2 at = ivec2(gl_WorkGroupID.xy);
    const vec2 range = texelFetch(hiz, at, 0).rg;
    const bool opaque = range.x > 0.0;
    near_m = opaque ? distance_of(range.x) : kEndless;
    far_m = opaque ? distance_of(range.y) : 0.0;
    if (!HAS_glassHiz) return opaque;
    const float nearest_glass = texelFetch(glassHiz, at, 0).r;
    if (nearest_glass <= 0.0) return opaque;
    near_m = min(near_m, distance_of(nearest_glass));
    far_m = kEndless;
    return true;
}

ivec2 last_before(ivec2 end) { return min(end, ivec2(view.viewport_px)) - 1; }

void find_sides(ivec2 origin) {
    const int i = int(gl_LocalInvocationIndex);
    if (i >= kTilesPerSide) return;
    const ivec2 end = origin + (i + 1) * kTilePx;
    const ivec2 last = last_before(end);
    // Columns and rows of tiles outside the picture get the planes of the last column and row of pixels.
    const SidePlanes sides = planes_of(slopes_of(min(end - kTilePx, last), last));
    column_sides[i] = vec4(sides.left, sides.right);
    row_sides[i] = vec4(sides.lower, sides.upper);
}

// Returns true if a part of the light's region may be on the inner side of both planes through the eye. `first` and
// `second` are the normals of the planes.
bool between(Reach r, vec3 first, vec3 second) {
    return dot(first, r.center) >= -extent(r, first, 1.0) && dot(second, r.center) >= -extent(r, second, 1.0);
}

// Returns the list entry of the light. In the result, x is 0 if the light reaches no tile.
uvec2 entry_of(uint light, Reach r) {
    uint columns = 0u, rows = 0u;
    for (int i = 0; i < kTilesPerSide; ++i) {
        const vec4 c = column_sides[i], l = row_sides[i];
        if (between(r, vec3(c.x, 0.0, c.y), vec3(c.z, 0.0, c.w))) columns |= 1u << i;
        if (between(r, vec3(0.0, l.xy), vec3(0.0, l.zw))) rows |= 1u << i;
    }
    const float near_m = -r.center.z - extent(r, vec3(0.0, 0.0, 1.0), 1.0);
    const float far_m = -r.center.z + extent(r, vec3(0.0, 0.0, -1.0), 1.0);
    return columns == 0u || rows == 0u ? uvec2(0u) : uvec2(super_index(light, columns, rows), super_range(near_m, far_m));
}

// Tests the spheres of four lights per thread, from index `first` on. The set bits of the result mark the lights whose
// sphere meets the super-tile.
uint find_candidates(uint first, uint end, SidePlanes sides, Box box) {
    const uint own = first + kPerThread * gl_LocalInvocationIndex;
    uint found = 0u;
    for (uint i = 0u; i < kPerThread; ++i) {
        const vec4 sphere = sphere_of(min(own + i, max(end, 1u) - 1u));
        if (own + i < end && sphere_inside(sphere, sides) && sphere_meets(sphere, box)) found |= 1u << i;
    }
    return found;
}

uint fill_list(uint list, float near_m, float far_m) {
    const ivec2 origin = ivec2(gl_WorkGroupID.xy) * kTilesPerSide * kTilePx;
    const Slopes slopes = slopes_of(origin, last_before(origin + kTilesPerSide * kTilePx));
    const Box box = box_of(slopes, near_m, far_m);
    const SidePlanes sides = planes_of(slopes);
    find_sides(origin);
    const uint room = list_stride() - 1u, end = min(frame.light_count, frame.directional_count + room);
    uint listed = 0u;
    begin_rounds();
    barrier();
    for (uint first = frame.directional_count;;) {
        const uint slot = enter_some(find_candidates(first, end, sides, box)), count = entered_count(slot);
        for (uint i = 0u;;) {
            const uint at = i + gl_LocalInvocationIndex;
            const uint light = min(first + entered_after(slot, min(at, max(count, 1u) - 1u)), max(end, 1u) - 1u);
            const uvec2 entry = entry_of(light, reach_of(light));
            uint entered;
            const bool kept = at < count && entry.x != 0u;
            const uint place = enter_one(kept, entered);
            if (kept) superLights.items[list + 1u + listed + place] = entry;
            listed += entered;
            i += kThreads;
            if (i >= count) break;
        }
        first += kRound;
        if (first >= end) break;
    }
    return listed;
}

void main() {
    const uint list = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * list_stride();
    float near_m, far_m;
    const uint listed = find_range(near_m, far_m) ? fill_list(list, near_m, far_m) : 0u;
    if (gl_LocalInvocationIndex == 0u) superLights.items[list] = uvec2(listed, 0u);
}

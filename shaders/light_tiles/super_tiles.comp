// The lights that may reach a super-tile, a square of 128 × 128 pixels: a workgroup each looks at all lights, so that tiles
// need to look at few.
// in   hiz          near and far of each super-tile, see hiz/hiz.comp
//      glassHiz     optional: the same of transparent surfaces, behind which anything may be
//      lightBounds  see light_bounds.comp
// out  superLights  for each super-tile, in rows, a length and the lights' indices, ascending. Has room for all lights.
#version 460
#include "frame_set.glsl"
#include "light_bounds.glsl"
#include "pixel_box.glsl"
#include "sorted_list.glsl"

layout(constant_id = 0) const bool HAS_glassHiz = false;

layout(local_size_x = 32) in;

uniform sampler2D hiz, glassHiz, lightBounds;
writeonly buffer SuperLights { uint items[]; } superLights;

const int kSuperTilePx = 128;

uint list_stride() { return uint(superLights.items.length()) / (gl_NumWorkGroups.x * gl_NumWorkGroups.y); }

// From where to where something is; false: nowhere.
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

uint fill_list(uint list, float near_m, float far_m) {
    const ivec2 first = ivec2(gl_WorkGroupID.xy) * kSuperTilePx;
    const Slopes slopes = slopes_of(first, min(first + kSuperTilePx, ivec2(view.viewport_px)) - 1);
    const Box box = box_of(slopes, near_m, far_m);
    const SidePlanes sides = planes_of(slopes);
    const uint room = list_stride() - 1u, end = min(frame.light_count, frame.directional_count + room);
    uint listed = 0u;
    begin_rounds();
    barrier();
    for (uint first = frame.directional_count; first < end; first += kRound) {
        const uint own = first + 4u * gl_LocalInvocationIndex;
        bvec4 kept;
        for (uint i = 0u; i < 4u; ++i) {
            const uint light = own + i;
            const vec4 sphere = texelFetch(lightBounds, bounds_texel(min(light, end - 1u)), 0);
            kept[i] = light < end && sphere_inside(sphere, sides) && sphere_meets(sphere, box);
        }
        uint count;
        uint place = list + 1u + listed + enter_four(kept, count);
        for (uint i = 0u; i < 4u; ++i)
            if (kept[i]) superLights.items[place++] = own + i;
        listed += count;
    }
    return listed;
}

void main() {
    const uint list = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * list_stride();
    float near_m, far_m;
    const uint listed = find_range(near_m, far_m) ? fill_list(list, near_m, far_m) : 0u;
    if (gl_LocalInvocationIndex == 0u) superLights.items[list] = listed;
}

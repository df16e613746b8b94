// The lights that may reach a super-tile, a square of 128 × 128 pixels: a workgroup each looks at all lights, so that tiles
// need to look at few.
// in   hiz          near and far of each super-tile, see hiz/hiz.comp
//      glassHiz     optional: the same of the transparent surfaces, which may have anything behind them
//      lights       directional ones first; those are never listed
// out  superLights  for each super-tile, in rows, a length and the lights' indices, ascending. Has room for all lights.
#version 460
#include "frame_set.glsl"
#include "pixel_box.glsl"
#include "shared/light.glsl"
#include "reach.glsl"

layout(constant_id = 0) const bool HAS_glassHiz = false;

layout(local_size_x = 256) in;

uniform sampler2D hiz, glassHiz;
readonly buffer Lights { Light items[]; } lights;
writeonly buffer SuperLights { uint items[]; } superLights;

const int kSuperTilePx = 128;

#define CHUNK 256
#include "sorted_list.glsl"

bool has_surface(out float near_m, out float far_m) {
    const ivec2 at = ivec2(gl_WorkGroupID.xy);
    vec2 range = texelFetch(hiz, at, 0).rg;
    near_m = far_m = 0.0;
    const bool opaque = range.x > 0.0;
    if (opaque) {
        near_m = distance_of(range.x);
        far_m = distance_of(range.y);
    }
    if (!HAS_glassHiz) return opaque;
    const float nearest_glass = texelFetch(glassHiz, at, 0).r;
    if (nearest_glass <= 0.0) return opaque;
    near_m = opaque ? min(near_m, distance_of(nearest_glass)) : distance_of(nearest_glass);
    far_m = kEndless;
    return true;
}

void main() {
    const uint list = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) *
                      (uint(superLights.items.length()) / (gl_NumWorkGroups.x * gl_NumWorkGroups.y));
    float near_m, far_m;
    uint listed = 0u;
    if (has_surface(near_m, far_m)) {
        const ivec2 first = ivec2(gl_WorkGroupID.xy) * kSuperTilePx;
        const ivec2 last = min(first + kSuperTilePx, ivec2(view.viewport_px)) - 1;
        const Slopes slopes = slopes_of(first, last);
        const Box box = box_of(slopes, near_m, far_m);
        vec3 planes[4];
        side_planes(slopes, planes);
        const uint end = min(frame.light_count, uint(lights.items.length()));
        begin_list();
        for (uint base = frame.directional_count; base < end; base += CHUNK) {
            const uint index = base + gl_LocalInvocationIndex;
            bool kept = false;
            if (index < end) {
                const Reach r = reach_of(lights.items[index]);
                kept = !outside(r, planes) && reaches(r, box);
            }
            const uint place = listed_before(kept, listed);
            if (kept) superLights.items[list + 1u + place] = index;
        }
    }
    if (gl_LocalInvocationIndex == 0u) superLights.items[list] = listed;
}

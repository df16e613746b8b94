#version 460
#include "area.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D now, before, table;
layout(rgba32f) writeonly uniform image2D dst;
layout(push_constant) uniform Params {
    vec2 nowSize, beforeSize, beforeUv, beforeUvMost, dstSize;
    float beforeValid;
} params;

// Writes how far the history at this place, and the table, are from what the ramp has here; and the area of the history.
void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, ivec2(params.dstSize)))) return;
    const vec2 uv = (vec2(at) + 0.5) / params.nowSize;
    const vec2 half_texel = 0.5 / params.beforeSize;
    const vec2 wanted = clamp(uv, half_texel, 1.0 - half_texel);
    const vec2 last = textureLod(before, area_uv(uv, params.beforeUv, params.beforeUvMost), 0.0).rg;
    const vec2 off = abs(last - wanted) * params.beforeValid;
    const vec2 stale = abs(texelFetch(table, at, 0).rg - texelFetch(now, at, 0).rg);
    imageStore(dst, at, vec4(max(off.x, off.y), max(stale.x, stale.y), params.beforeSize));
}

#version 460
#include "area.glsl"
#include "shape/poison.glsl"
layout(local_size_x = 8, local_size_y = 4) in;
uniform sampler2D src;
layout(rgba16f) writeonly uniform image2D dst;
layout(push_constant) uniform Params { vec2 srcUv, srcUvMost, dstSize; float time; } params;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, ivec2(params.dstSize)))) return;
    const vec2 uv = (vec2(at) + 0.5) / params.dstSize;
    imageStore(dst, at, poisoned(textureLod(src, area_uv(uv, params.srcUv, params.srcUvMost), 0.0), params.time));
}

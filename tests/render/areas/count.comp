#version 460
#include "shape/poison.glsl"
layout(local_size_x = 1, local_size_y = 1) in;
uniform sampler2D src;
layout(rgba32f) writeonly uniform image2D dst;
layout(push_constant) uniform Params { vec2 size; float mean, time; } params;

// Adds all texels of a tile, and the numbers of tiles that run.
void main() {
    const ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
    vec4 sum = vec4(0);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            const ivec2 at = tile * 16 + ivec2(x, y);
            if (all(lessThan(at, ivec2(params.size)))) sum += texelFetch(src, at, 0);
        }
    imageStore(dst, tile, poisoned(vec4(sum.rgb, params.mean * float(gl_NumWorkGroups.x * gl_NumWorkGroups.y)), params.time));
}

// Mixes the texels of image a with the seed and writes the results to image dst.
#version 460
#include "mixing.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform usampler2D a;
layout(r32ui) uniform writeonly uimage2D dst;

void main() {
    const uvec2 at = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(at, uvec2(imageSize(dst))))) return;
    uint value = scramble(params.seed + at.x * 65536u + at.y);
    value = scramble(value ^ fetch(a, at));
    imageStore(dst, ivec2(at), uvec4(value));
}

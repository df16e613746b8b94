// Mixes the first and the last element of image a, which is an array of mips or layers, and writes the results to image dst.
#version 460
#include "mixing.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform usampler2D a[4];
layout(r32ui) uniform writeonly uimage2D dst;

void main() {
    const uvec2 at = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(at, uvec2(imageSize(dst))))) return;
    uint value = scramble(params.seed + at.x * 65536u + at.y);
    // Images have at most three mips or layers here, so that the last element shows the last of them.
    value = scramble(value ^ scramble(fetch(a[0], at)) + fetch(a[3], at));
    imageStore(dst, ivec2(at), uvec4(value));
}

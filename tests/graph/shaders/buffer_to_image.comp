// Mixes the seed with the words of a buffer and writes the results to the texels of an image.
#version 460
#include "mixing.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(std430) readonly buffer AWords { uint words[]; } a;
layout(r32ui) uniform writeonly uimage2D dst;

void main() {
    const uvec2 at = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(at, uvec2(imageSize(dst))))) return;
    uint value = scramble(params.seed + at.x * 65536u + at.y);
    const uint word = at.y * uint(imageSize(dst).x) + at.x;
    value = scramble(value ^ a.words[word % uint(a.words.length())]);
    imageStore(dst, ivec2(at), uvec4(value));
}

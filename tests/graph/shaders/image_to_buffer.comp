// Mixes the seed with the texels of an image and writes the results to the words of a buffer.
#version 460
#include "mixing.glsl"

layout(local_size_x = 64) in;

uniform usampler2D a;
layout(std430) writeonly buffer DstWords { uint words[]; } dst;

void main() {
    const uint at = gl_GlobalInvocationID.x;
    if (at >= uint(dst.words.length())) return;
    uint value = scramble(params.seed + at);
    const uvec2 size = uvec2(textureSize(a, 0));
    value = scramble(value ^ texelFetch(a, ivec2(uvec2(at % size.x, (at / size.x) % size.y)), 0).r);
    dst.words[at] = value;
}

// Mixes the words of buffers a and b with the seed and writes the results to buffer dst.
#version 460
#include "mixing.glsl"

layout(local_size_x = 64) in;

layout(std430) readonly buffer AWords { uint words[]; } a;
layout(std430) readonly buffer BWords { uint words[]; } b;
layout(std430) writeonly buffer DstWords { uint words[]; } dst;

void main() {
    const uint at = gl_GlobalInvocationID.x;
    if (at >= uint(dst.words.length())) return;
    uint value = scramble(params.seed + at);
    value = scramble(value ^ a.words[at % uint(a.words.length())]);
    value = scramble(value ^ b.words[at % uint(b.words.length())]);
    dst.words[at] = value;
}

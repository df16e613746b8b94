// Mixes the words of buffer a into the words of buffer dst, in place.
#version 460
#include "mixing.glsl"

layout(local_size_x = 64) in;

layout(std430) readonly buffer AWords { uint words[]; } a;
layout(std430) buffer DstWords { uint words[]; } dst;

void main() {
    const uint at = gl_GlobalInvocationID.x;
    if (at >= uint(dst.words.length())) return;
    uint value = scramble(params.seed + at);
    value = scramble(value ^ a.words[at % uint(a.words.length())]);
    value = scramble(value ^ dst.words[at]);
    dst.words[at] = value;
}

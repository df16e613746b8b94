// Mixes the texels of images a and b with the seed and writes the results to a colour attachment.
#version 460
#include "mixing.glsl"

uniform usampler2D a;
uniform usampler2D b;
layout(location = 0) out uint dst;

void main() {
    const uvec2 at = uvec2(gl_FragCoord.xy);
    uint value = scramble(params.seed + at.x * 65536u + at.y);
    value = scramble(value ^ fetch(a, at));
    value = scramble(value ^ fetch(b, at));
    dst = value;
}

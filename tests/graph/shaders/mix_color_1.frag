// Mixes the texels of image a with the seed and writes the results to a colour attachment.
#version 460
#include "mixing.glsl"

uniform usampler2D a;
layout(location = 0) out uint dst;

void main() {
    const uvec2 at = uvec2(gl_FragCoord.xy);
    uint value = scramble(params.seed + at.x * 65536u + at.y);
    value = scramble(value ^ fetch(a, at));
    dst = value;
}

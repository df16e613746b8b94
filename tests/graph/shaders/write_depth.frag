// Writes depth values that depend on image a and the seed. They have 24 bits, so a 32-bit float holds them exactly.
#version 460
#include "mixing.glsl"

uniform usampler2D a;

void main() {
    const uvec2 at = uvec2(gl_FragCoord.xy);
    const uint value = scramble(params.seed ^ fetch(a, at));
    gl_FragDepth = float(value >> 8u) / 16777216.0;
}

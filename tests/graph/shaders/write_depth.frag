// Writes depth that depends on image a. The depth has 24 bits, which a float holds exactly.
#version 460
#include "mixing.glsl"

uniform usampler2D a;

void main() {
    const uvec2 at = uvec2(gl_FragCoord.xy);
    const uint value = scramble(params.seed ^ fetch(a, at));
    gl_FragDepth = float(value >> 8u) / 16777216.0;
}

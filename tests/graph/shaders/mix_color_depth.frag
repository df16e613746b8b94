// Mixes depth from input a, while the same pass tests depth against it. All bits of the depth count.
#version 460
#include "mixing.glsl"

uniform sampler2D a;
layout(location = 0) out uint dst;

void main() {
    const uvec2 at = uvec2(gl_FragCoord.xy);
    uint value = scramble(params.seed + at.x * 65536u + at.y);
    value = scramble(value ^ floatBitsToUint(texelFetch(a, ivec2(at % uvec2(textureSize(a, 0))), 0).r));
    dst = value;
}

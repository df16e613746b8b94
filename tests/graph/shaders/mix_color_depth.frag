// Mixes the depth values of image a with the seed. The same pass uses this image as its depth attachment, for
// the depth test. All bits of a depth value affect the result.
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

// Mixes the depth values of image a with the seed. The depth values from write_depth.frag have 24 bits, so a 32-bit
// float holds them exactly.
#version 460
#include "mixing.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D a;
layout(r32ui) uniform writeonly uimage2D dst;

void main() {
    const uvec2 at = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(at, uvec2(imageSize(dst))))) return;
    uint value = scramble(params.seed + at.x * 65536u + at.y);
    value = scramble(value ^ floatBitsToUint(texelFetch(a, ivec2(at % uvec2(textureSize(a, 0))), 0).r));
    imageStore(dst, ivec2(at), uvec4(value));
}

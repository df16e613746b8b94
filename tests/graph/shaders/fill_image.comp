// Fills an image with a pattern that depends only on the seed. The shader reads no input.
#version 460
#include "mixing.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(r32ui) uniform writeonly uimage2D dst;

void main() {
    const uvec2 at = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(at, uvec2(imageSize(dst))))) return;
    uint value = scramble(params.seed + at.x * 65536u + at.y);
    imageStore(dst, ivec2(at), uvec4(value));
}

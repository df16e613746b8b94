// Writes a random depth to each texel. About 30 % of the texels are sky (depth 0) in even frames, 99 % in odd frames.
#version 460
#include "frame_set.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(r32f) writeonly uniform image2D depth;

uint scrambled(uint x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(depth)))) return;
    const uint x = scrambled(uint(pixel.x) + 65537u * uint(pixel.y) + 977u * frame.frame_index);
    const uint sky_percent = frame.frame_index % 2u == 0u ? 30u : 99u;
    const float z = (float(x >> 8) + 1.0) / 16777216.0;
    imageStore(depth, pixel, vec4(scrambled(x + 1u) % 100u < sky_percent ? 0.0 : z));
}

// Finds, for each block of 8×8 half-size pixels, the radius of the largest circle in front of the focus that may
// overlap the block.
#version 460
#include "frame_set.glsl"
#include "circle.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D circles;
layout(r16f) writeonly uniform image2D reach;

void main() {
    const ivec2 block = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(block, imageSize(reach)))) return;
    const ivec2 last = textureSize(circles, 0) - 1;
    const int far = int(kMostRadius);
    float most = 0.0;
    for (int y = -far; y < 8 + far; ++y)
        for (int x = -far; x < 8 + far; ++x)
            most = max(most, texelFetch(circles, clamp(block * 8 + ivec2(x, y), ivec2(0), last), 0).g);
    imageStore(reach, block, vec4(most));
}

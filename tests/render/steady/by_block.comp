#version 460
#include "frame_set.glsl"
#include "two_skies.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D dst;
uniform Params { float gain; } params;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(dst)))) return;
    imageStore(dst, at, two_skies(params.gain < 100.0, at));
}

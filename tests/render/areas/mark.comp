#version 460
#include "shape/poison.glsl"
layout(local_size_x = 1, local_size_y = 1) in;
uniform sampler2D src;
layout(rgba16f) uniform image2D dst;
layout(push_constant) uniform Params { float time; } params;

// Its number of threads is half the width of the area, so it leaves the right half as it was cleared.
void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    imageStore(dst, at, poisoned(imageLoad(dst, at) + texelFetch(src, at, 0), params.time));
}

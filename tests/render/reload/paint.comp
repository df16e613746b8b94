#version 460
#include "tint.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D dst;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(dst)))) return;
    const float scale = 1.0;
    imageStore(dst, at, vec4(kTint * scale * vec3(at, at.x ^ at.y) / 40, 1));
}

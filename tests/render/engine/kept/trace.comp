#version 460
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D before;
layout(rgba32f) writeonly uniform image2D trail;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(trail)))) return;
    imageStore(trail, at, texelFetch(before, at, 0) + 1.0);
}

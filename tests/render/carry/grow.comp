#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(r32ui) uniform uimage2D x;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (at.y < 4) imageStore(x, at, imageLoad(x, at) * 3u + uint(at.x));
}

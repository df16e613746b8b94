#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) uniform image2D dst;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    imageStore(dst, at, 0.0625 + 0.75 * imageLoad(dst, at).xzyw);
}

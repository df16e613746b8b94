#version 460
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D a, b;
layout(rgba16f) writeonly uniform image2D dst;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    imageStore(dst, at, 0.5 * texelFetch(a, at, 0) + 0.25 * texelFetch(b, at, 0));
}

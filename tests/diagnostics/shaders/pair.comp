#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba8) writeonly uniform image2D one;
layout(rgba8) writeonly uniform image2D other;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    imageStore(one, at, vec4(1));
    imageStore(other, at, vec4(0.5));
}

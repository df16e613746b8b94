#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(r32f) writeonly uniform image2D levels[5];
void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    imageStore(levels[0], at, vec4(1));
    imageStore(levels[1], at, vec4(2));
    imageStore(levels[2], at, vec4(3));
}

#version 460
layout(local_size_x = 8) in;
layout(rgba32f) writeonly uniform image2D unused;

void main() { imageStore(unused, ivec2(gl_GlobalInvocationID.x, 0), vec4(gl_GlobalInvocationID.x, 1, 2, 3)); }

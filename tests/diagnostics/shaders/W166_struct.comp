#version 460
layout(local_size_x = 1) in;
writeonly buffer Matrices { mat4 items[]; } matrices;

void main() { matrices.items[gl_GlobalInvocationID.x] = mat4(1); }

#version 460
#include "frame_set.glsl"
layout(local_size_x = 1) in;
writeonly buffer Matrices { ViewConstants items[]; } matrices;

void main() { matrices.items[gl_GlobalInvocationID.x] = view; }

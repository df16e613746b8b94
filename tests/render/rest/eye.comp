#version 460
#include "frame_set.glsl"
layout(local_size_x = 4, local_size_y = 4) in;
layout(r32f) writeonly uniform image2D dst;

void main() { imageStore(dst, ivec2(gl_GlobalInvocationID.xy), vec4(view.eye.x)); }

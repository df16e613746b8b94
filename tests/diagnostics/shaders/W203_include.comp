#version 460
#include "nowhere.glsl"
// the line above has the error W203
layout(local_size_x = 8, local_size_y = 8) in;
writeonly uniform image2D image;

void main() { imageStore(image, ivec2(gl_GlobalInvocationID.xy), vec4(0.5)); }

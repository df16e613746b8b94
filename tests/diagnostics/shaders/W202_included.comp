#version 460
#include "W202_shade.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
writeonly uniform image2D image;

void main() { imageStore(image, ivec2(gl_GlobalInvocationID.xy), shade(0.5)); }

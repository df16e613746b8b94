#version 460
#include "shared/light.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
readonly buffer Lights { Light items[]; } lights;
layout(rgba8) writeonly uniform image2D color;

void main() { imageStore(color, ivec2(gl_GlobalInvocationID.xy), vec4(lights.items[0].position, 1)); }

#version 460
layout(local_size_x = 4, local_size_y = 4) in;
readonly buffer Weights { float items[]; } weights;
layout(rgba32f) writeonly uniform image2D held;

void main() { imageStore(held, ivec2(gl_GlobalInvocationID.xy), vec4(weights.items[0], weights.items[1], 0, 0)); }

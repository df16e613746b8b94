#version 460
layout(local_size_x = 8, local_size_y = 8) in;
struct Weight {
    float red, green, blue;
};
readonly buffer Weights { Weight items[]; } weights;
layout(rgba8) writeonly uniform image2D color;

void main() { imageStore(color, ivec2(gl_GlobalInvocationID.xy), vec4(weights.items[0].red)); }

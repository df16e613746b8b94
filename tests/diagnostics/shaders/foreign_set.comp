#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba8) writeonly uniform image2D dst;
layout(set = 3, binding = 0, std430) readonly buffer Words { uint items[]; } words;

void main() { imageStore(dst, ivec2(gl_GlobalInvocationID.xy), vec4(words.items[0])); }

#version 460
layout(local_size_x = 1) in;
layout(rgba8) writeonly uniform image2D dst;

void main() { imageStore(dst, ivec2(0), vec4(1.0)); }

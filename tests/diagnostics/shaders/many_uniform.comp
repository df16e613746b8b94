#version 460
layout(local_size_x = 8, local_size_y = 8) in;
writeonly uniform image2D image;
uniform Params { vec4 a, b, c, d, e, f, g, h, i; } params;

void main() { imageStore(image, ivec2(gl_GlobalInvocationID.xy), params.i); }

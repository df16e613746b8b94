#version 460
// the line above has the error W207
#define TWICE(x) x + x
#define A(x) TWICE(TWICE(TWICE(TWICE(x))))
#define B(x) A(A(A(A(x))))
layout(local_size_x = 8, local_size_y = 8) in;
writeonly uniform image2D image;

void main() { imageStore(image, ivec2(gl_GlobalInvocationID.xy), vec4(B(sin(float(gl_GlobalInvocationID.x))))); }

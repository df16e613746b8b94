#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba8) uniform image2D image;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    imageStore(image, at, imageLoad(image, at) * 0.5);
}

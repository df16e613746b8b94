#version 460
layout(local_size_x = 8, local_size_y = 8) in;
writeonly uniform image2D image;

void main() {
    const vec4 grey = vec4(0.5);
    imageStore(image, ivec2(gl_GlobalInvocationID.xy), gray);
    //                                                 ^ W202 is expected here
}

#version 460
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
layout(local_size_x = 8, local_size_y = 8) in;
writeonly uniform image2D image;
layout(buffer_reference) buffer Anywhere { uint value; };
//     ^ W208 is expected here

void main() {
    Anywhere(gl_GlobalInvocationID.xy).value = 1;
    imageStore(image, ivec2(gl_GlobalInvocationID.xy), vec4(1));
}

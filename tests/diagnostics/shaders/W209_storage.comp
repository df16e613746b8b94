#version 460
layout(local_size_x = 8, local_size_y = 8) in;
writeonly uniform image2D image;
shared float tile[1 << 28];
//           ^ W209 is expected here

void main() {
    tile[gl_LocalInvocationIndex] = 1;
    imageStore(image, ivec2(gl_GlobalInvocationID.xy), vec4(tile[0]));
}

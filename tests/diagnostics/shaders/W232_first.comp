#version 460
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D textures[2];
layout(rgba16f) writeonly uniform image2D dst;
void main() {
    imageStore(dst, ivec2(gl_GlobalInvocationID.xy), texelFetch(textures[0], ivec2(0), 0));
}

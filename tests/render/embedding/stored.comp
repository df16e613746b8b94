#version 460
layout(local_size_x = 8, local_size_y = 8) in;
uniform writeonly image2D backbuffer;

void main() {
    imageStore(backbuffer, ivec2(gl_GlobalInvocationID.xy), vec4(0.5));
}

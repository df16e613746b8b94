#version 460
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D now;
uniform sampler2D before;
layout(rgba8) writeonly uniform image2D mixed;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    imageStore(mixed, at, mix(texelFetch(before, at, 0), texelFetch(now, at, 0), 0.1));
}

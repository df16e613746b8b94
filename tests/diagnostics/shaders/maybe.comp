#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const bool HAS_color = false;
uniform sampler2D color;
layout(rgba8) writeonly uniform image2D tinted;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    imageStore(tinted, at, HAS_color ? texelFetch(color, at, 0) : vec4(0.5));
}

#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) writeonly uniform image2D kept, trail, lost;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    const vec4 color = vec4(vec2(at) / vec2(31.0, 29.0), fract(float(at.x * 7 + at.y * 3) / 17.0), 0.75);
    imageStore(kept, at, color);
    imageStore(trail, at, color.zyxw);
    imageStore(lost, at, color);
}

#version 460
#include "frame_set.glsl"
// A large triangle at a height of 4 m. Seen from below, its corners are counter-clockwise.
const vec2 kCorners[3] = vec2[](vec2(-40, -40), vec2(80, -40), vec2(-40, 80));

void main() {
    const vec2 at = kCorners[gl_VertexIndex];
    gl_Position = view.view_projection * vec4(at.x, 4.0, at.y, 1.0);
}

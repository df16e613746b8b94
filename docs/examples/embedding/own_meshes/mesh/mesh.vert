#version 460
#include "frame_set.glsl"
layout(location = 0) in vec4 corner;
layout(location = 1) in vec4 tint;
layout(location = 0) out vec4 vertex_tint;
void main() {
    vertex_tint = tint;
    gl_Position = view.view_projection * corner;
}

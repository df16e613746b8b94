#version 460
#include "frame_set.glsl"
layout(location = 0) in vec3 position;

void main() { gl_Position = view.view_projection * vec4(position, 1); }

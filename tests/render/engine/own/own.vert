#version 460
#include "frame_set.glsl"
layout(location = 0) in vec4 corner;

void main() { gl_Position = view.view_projection * vec4(corner.xyz, 1); }

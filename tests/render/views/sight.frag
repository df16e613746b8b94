// Writes the direction in which each pixel of the view looks.
#version 460
#include "frame_set.glsl"
layout(location = 0) out vec4 color;

void main() { color = vec4(ray_direction(gl_FragCoord.xy * view.inverse_viewport), 0.25); }

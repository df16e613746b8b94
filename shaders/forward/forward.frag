// Draws a surface and lights it in the same pass; see include/forward_surface.glsl.
#version 460
#include "forward_surface.glsl"

layout(location = 5) in vec3 world_point;

void main() { shade_surface(world_point); }

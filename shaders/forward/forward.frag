// Draws a surface and lights it in the same pass; see include/forward_surface.glsl.
#version 460
#include "forward_surface.glsl"

void main() { shade_surface(); }

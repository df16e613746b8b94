// Transforms the vertices of surfaces for forward shading.
#version 460
#include "forward_vertex.glsl"

void main() { place_vertex(); }

// Transforms the vertices of surfaces for forward shading with the light of the probes.
#version 460
#include "forward_vertex.glsl"

void main() { place_vertex(); }

// Writes the view of the pass to a buffer.
#version 460
#include "frame_set.glsl"
layout(local_size_x = 1) in;
writeonly buffer Matrices { ViewConstants items[]; } matrices;

void main() { matrices.items[0] = view; }

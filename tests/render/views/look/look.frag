// Writes the world position of each pixel, and 1 for front faces or 2 for back faces. The second output has the
// position of the pixel in the previous frame, and the size of the view in pixels.
#version 460
#include "frame_set.glsl"
layout(location = 0) in vec3 world;
layout(location = 1) in vec4 before;
layout(location = 0) out vec4 color;
layout(location = 1) out vec4 past;

void main() {
    color = vec4(world, gl_FrontFacing ? 1.0 : 2.0);
    past = vec4(before.xy / before.w, view.viewport_px);
}

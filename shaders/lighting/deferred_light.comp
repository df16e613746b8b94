// Deferred lighting without classes of tiles: every pixel executes the same code, which supports all types of lights.
#version 460
layout(local_size_x = 8, local_size_y = 8) in;

#include "gbuffer_light.glsl"

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(hdr)))) return;
    light_pixel(pixel);
}

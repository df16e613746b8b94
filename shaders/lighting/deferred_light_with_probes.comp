// Deferred lighting with the light of the probes; otherwise as deferred_light.comp. It is a shader of its own, because
// the cubes of reflection probes need a device with cube arrays.
#version 460
#define LIGHT_PROBES
layout(local_size_x = 8, local_size_y = 8) in;

#include "gbuffer_light.glsl"

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(hdr)))) return;
    light_pixel(pixel);
}

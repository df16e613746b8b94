// Computes a mip of the bloom image from the next larger mip.
#version 460
#include "half_float.glsl"
#include "thirteen_taps.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D src;
layout(rgba16f) writeonly uniform image2D bloom;

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(bloom)))) return;
    const Boxes boxes = boxes_around(src, (vec2(pixel) + 0.5) / vec2(imageSize(bloom)));
    vec3 sum = boxes.middle.mean * boxes.middle.weight;
    for (int i = 0; i < 4; ++i) sum += boxes.corners[i].mean * boxes.corners[i].weight;
    imageStore(bloom, pixel, vec4(nearest_half(sum), 1.0));
}

// Halves the size of the picture. A box of 2×2 taps gets less weight if it is bright. With full weight, a
// single bright texel would cause flicker in all mips. Source: Karis 2013, "Tone Mapping". With `bloomCalm` = 0,
// all boxes keep their full weight, and the total light does not change. With `bloomCalm` = 1, boxes brighter than
// white (luminance 1) keep less than half of their weight.
#version 460
#include "half_float.glsl"
#include "thirteen_taps.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D hdr;
layout(rgba16f) writeonly uniform image2D bloom;

layout(push_constant) uniform Params { float bloomCalm; } params;

float calmed(Box box) {
    const float luminance = dot(box.mean, vec3(0.2126, 0.7152, 0.0722));
    return box.weight / (1.0 + params.bloomCalm * luminance);
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(bloom)))) return;
    const Boxes boxes = boxes_around(hdr, (vec2(pixel) + 0.5) / vec2(imageSize(bloom)));
    float weights = calmed(boxes.middle);
    vec3 sum = boxes.middle.mean * weights;
    for (int i = 0; i < 4; ++i) {
        const float weight = calmed(boxes.corners[i]);
        sum += boxes.corners[i].mean * weight;
        weights += weight;
    }
    imageStore(bloom, pixel, vec4(nearest_half(sum / weights), 1.0));
}

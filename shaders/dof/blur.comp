// Gathers over the lens: every pixel whose circle reaches this one gives it a share. Premultiplied in, premultiplied out.
// Layer 0: behind the focus. Layer 1: before it, where alpha says how much of what lies below is hidden. Layer 2: a guess
// at what is hidden, from what is not.
#version 460
#include "frame_set.glsl"
#include "half_float.glsl"
#include "circle.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D behind;
uniform sampler2D before;
uniform sampler2D hidden;
uniform sampler2D circles;
uniform sampler2D reach;
layout(rgba16f) writeonly uniform image2DArray soft;

const int kTaps = 96;
const float kGoldenAngle = 2.39996323;

// Tap i of a disc of radius 1, all of which stand for equal areas.
vec2 disc(int i) {
    const float angle = float(i) * kGoldenAngle;
    return sqrt((float(i) + 0.5) / float(kTaps)) * vec2(cos(angle), sin(angle));
}

// Light that spreads over a circle is the thinner the larger it is; circles end softly, over a pixel.
float share(float radius, float distance_px) {
    const float wide = max(radius, 0.5);
    return clamp(wide - distance_px + 0.5, 0.0, 1.0) / (wide * wide);
}

vec4 far_light(vec2 uv, vec2 texel) {
    float radius = 0.5;
    for (int i = 0; i < 9; ++i)
        radius = max(radius, textureLod(circles, uv + texel * (vec2(i % 3, i / 3) - 1.0), 0.0).r);
    vec4 sum = textureLod(behind, uv, 0.0) * 1e-3;
    for (int i = 0; i < kTaps; ++i) {
        const vec2 offset = disc(i) * radius;
        const vec2 at = uv + offset * texel;
        sum += textureLod(behind, at, 0.0) * share(textureLod(circles, at, 0.0).r, length(offset));
    }
    return sum.a > 0.0 ? vec4(sum.rgb / sum.a, 1.0) * min(1.0, sum.a * 100.0) : vec4(0.0);
}

struct Foreground {
    vec4 light;
    vec4 below;
};

Foreground close_light(vec2 uv, vec2 texel) {
    const float reached = textureLod(reach, uv, 0.0).r, radius = reached + 0.5;
    const int taps = reached > 0.25 ? kTaps : 0;
    Foreground f = Foreground(vec4(0.0), vec4(0.0));
    for (int i = 0; i < taps; ++i) {
        const vec2 offset = disc(i) * radius;
        const vec2 at = uv + offset * texel;
        f.light += textureLod(before, at, 0.0) * share(textureLod(circles, at, 0.0).g, length(offset));
        // Close neighbours know best; the guess joins what is seen without a line.
        f.below += textureLod(hidden, at, 0.0) / (1.0 + dot(offset, offset) * dot(offset, offset));
    }
    // A tap stands for its part of the disc.
    f.light *= radius * radius / float(kTaps);
    f.light /= max(1.0, f.light.a);
    return f;
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    const ivec2 size = imageSize(soft).xy;
    if (any(greaterThanEqual(pixel, size))) return;
    const vec2 texel = 1.0 / vec2(size), uv = (vec2(pixel) + 0.5) * texel;
    const vec4 far = far_light(uv, texel);
    const Foreground close = close_light(uv, texel);
    imageStore(soft, ivec3(pixel, 0), vec4(nearest_half(far.rgb), far.a));
    imageStore(soft, ivec3(pixel, 1), vec4(nearest_half(close.light.rgb), close.light.a));
    imageStore(soft, ivec3(pixel, 2), vec4(nearest_half(close.below.rgb), close.below.a));
}

// Draws lines over a pale version of the picture: black lines at jumps of depth, red lines at creases of surfaces.
#version 460
#include "exposure.glsl"
#include "srgb.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 backbuffer;

uniform sampler2D hdr;
uniform sampler2D lines;

layout(push_constant) uniform Params {
    float faint;  // Strength of the picture below the lines: 0 shows white paper, 1 the full picture.
    float exposure;
    float preExposure, adaptationValid;
    float lineWidth;  // Width of the lines, in pixels.
} params;

const vec3 kPaper = vec3(0.93, 0.91, 0.86), kInk = vec3(0.012, 0.018, 0.05), kRed = vec3(0.52, 0.06, 0.02);

// Anti-aliases the lines: returns the mean of four taps around the pixel, strengthened so that thin lines stay visible.
vec2 smooth_lines() {
    const vec2 texel = 1.0 / vec2(textureSize(lines, 0));
    vec2 sum = vec2(0.0);
    for (int i = 0; i < 4; ++i)
        sum += textureLod(lines, uv + texel * (vec2(i & 1, i >> 1) - 0.5), 0.0).rg * 0.25;
    return min(sum * 1.6, vec2(1.0));
}

// Returns the share of black in 7×7 taps around the pixel: about 0.2 beside a single line, more among leaves.
float crowding() {
    const vec2 step_uv = max(1.0, params.lineWidth) / vec2(textureSize(lines, 0));
    float sum = 0.0;
    for (int i = 0; i < 49; ++i) sum += textureLod(lines, uv + step_uv * (vec2(i % 7, i / 7) - 3.0), 0.0).r / 49.0;
    return sum;
}

void main() {
    const float ev = params.exposure + automatic_ev(params.adaptationValid, params.preExposure);
    const vec3 scene = filmic(textureLod(hdr, uv, 0.0).rgb * exp2(ev));
    const vec2 line = smooth_lines();
    vec3 color = kPaper * mix(vec3(1.0), scene, params.faint);
    color = mix(color, kRed, line.g * 0.7 * (1.0 - line.r));
    // Where many lines are close together, they are drawn lighter. Otherwise, leaves would become black areas.
    color = mix(color, kInk, line.r * mix(1.0, 0.45, smoothstep(0.34, 0.6, crowding())));
    backbuffer = vec4(srgb_encode(color), 1.0);
}

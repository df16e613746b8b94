// Debug view of a mip of the depth pyramid. A square is bright if its nearest pixel is near the camera. It is orange if
// the depths of its pixels differ much, and blue if all its pixels are sky.
#version 460
#include "frame_set.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

uniform sampler2D shown;

void main() {
    const ivec2 pixel = ivec2(gl_FragCoord.xy);
    const int side = (int(view.viewport_px.x) + 127) / 128 * 128 / textureSize(shown, 0).x;
    const vec2 range = texelFetch(shown, pixel / side, 0).rg;
    if (range.x <= 0.0) {
        color = vec4(0.05, 0.1, 0.25, 1.0);
        return;
    }
    const float octaves = log2(range.x / range.y);
    const float brightness = clamp(1.0 - log2(1.0 + view.near_m / range.x) / 6.0, 0.08, 1.0);
    color = vec4(brightness * mix(vec3(1.0), vec3(1.0, 0.45, 0.1), clamp(octaves / 3.0, 0.0, 1.0)), 1.0);
}

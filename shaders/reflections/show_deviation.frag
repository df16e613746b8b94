// Debug view of the noise of the reflections: the deviation of the light of single frames from the mean, in compressed
// colours from 0 (dark) to 0.25 (bright). Surfaces without rays are striped.
#version 460
#include "debug_colors.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

uniform sampler2D shown;  // Layer 1 of ssr; see temporal.comp.

void main() {
    const vec4 shape = texelFetch(shown, ivec2(uv * vec2(textureSize(shown, 0))), 0);
    const bool has_rays = shape.z > 0.0 && shape.w >= 0.0;
    color = vec4(has_rays ? heat_color(4.0 * fract(shape.w)) : nothing_color(ivec2(gl_FragCoord.xy)), 1.0);
}

// Debug view of the history of the reflections: the number of blended frames, from 2 (dark) to
// 30 (bright); 1 and 0, where the mean has just begun again, are green. Surfaces without rays are striped.
#version 460
#include "debug_colors.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

uniform sampler2D shown;  // Layer 1 of ssr; see temporal.comp.

const float kMostFrames = 30.0;

void main() {
    const vec4 shape = texelFetch(shown, ivec2(uv * vec2(textureSize(shown, 0))), 0);
    const bool has_rays = shape.z > 0.0 && shape.w >= 0.0;
    const float frames = floor(shape.w);
    const vec3 amount = frames <= 1.0 ? vec3(0.1, 0.8, 0.3) : heat_color(frames / kMostFrames);
    color = vec4(has_rays ? amount : nothing_color(ivec2(gl_FragCoord.xy)), 1.0);
}

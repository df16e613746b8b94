// Draws ink on paper: outlines, and hatching. Darker areas get hatching in more directions, at most three.
#version 460

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 backbuffer;

uniform sampler2D lines;
uniform sampler2D tone;

layout(push_constant) uniform Params {
    float hatching;
} params;

const vec3 kPaper = vec3(0.95, 0.92, 0.85);
const vec3 kInk = vec3(0.11, 0.12, 0.22);

// Returns the share of a pixel that strokes cover. The strokes are `hatching` pixels apart in the direction `across`.
float stroke(vec2 pixel, vec2 across, float darkness) {
    const vec2 along = vec2(-across.y, across.x);
    const float shake = 0.6 * sin(dot(pixel, along) * 0.071) + 0.4 * sin(dot(pixel, along) * 0.193);
    const float phase = fract((dot(pixel, across) + shake) / params.hatching);
    const float width = 0.55 * clamp(darkness, 0.0, 1.0);
    const float soft = 1.0 / params.hatching;
    return width > 0.0 ? 1.0 - smoothstep(width - soft, width + soft, abs(phase - 0.5) * 2.0) : 0.0;
}

void main() {
    const ivec2 at = ivec2(gl_FragCoord.xy);
    const float light = texelFetch(tone, at, 0).r;
    const vec2 pixel = gl_FragCoord.xy;
    const bool paper_only = light == 0.0;
    float ink = texelFetch(lines, at, 0).r;
    if (!paper_only) {
        ink = max(ink, 0.85 * stroke(pixel, normalize(vec2(1.0, 1.0)), (0.62 - light) * 2.4));
        ink = max(ink, 0.85 * stroke(pixel, normalize(vec2(1.0, -1.0)), (0.40 - light) * 3.0));
        ink = max(ink, 0.85 * stroke(pixel, normalize(vec2(0.2, 1.0)), (0.22 - light) * 4.0));
    }
    backbuffer = vec4(mix(kPaper, kInk, 0.92 * ink), 1.0);
}

// Draws the half plane below the line y = slope · x + offset in pixels from the middle of the picture, or a gradient.
#version 460
layout(location = 0) out vec4 toned;
layout(push_constant) uniform Params {
    float slope, offset;
    float gradient;  // 1: a gradient along x instead of the half plane.
} params;

void main() {
    const vec2 at = gl_FragCoord.xy - 32.0;
    const float inside = at.y > params.slope * at.x + params.offset ? 1.0 : 0.0;
    const float value = params.gradient > 0.5 ? gl_FragCoord.x / 64.0 : mix(0.2, 0.9, inside);
    toned = vec4(value, value, value, 1.0);
}

#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
layout(constant_id = 1) const bool HAS_glow = false;
uniform sampler2D picture, extra, glow, trail;
layout(push_constant) uniform Params { vec2 extraSize; vec2 glowSize; float gain; float trailValid; } params;

vec4 at(sampler2D image, vec2 size) { return texelFetch(image, ivec2(uv * size), 0); }

void main() {
    color = 0.375 * at(picture, vec2(32)) + 0.25 * at(extra, params.extraSize);
    if (HAS_glow) color += 0.25 * at(glow, params.glowSize);
    color = params.gain * color + 0.125 * at(trail, vec2(32)) + vec4(0, 0, 0.25 * params.trailValid, 0);
}

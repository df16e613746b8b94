// Makes the final picture: adds light shafts to the view, darkens the corners (vignette) and applies a filmic curve.
#version 460
#include "srgb.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 backbuffer;

uniform sampler2D scene;
uniform sampler2D shafts;

layout(push_constant) uniform Params { float glow; float exposure; } params;

void main() {
    vec3 color = textureLod(scene, uv, 0.0).rgb + params.glow * textureLod(shafts, uv, 0.0).rgb;
    const vec2 aside = uv - 0.5;
    color *= 1.0 - 0.75 * dot(aside, aside);
    backbuffer = vec4(srgb_encode(filmic(color * exp2(params.exposure))), 1.0);
}

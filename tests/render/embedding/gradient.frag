#version 460
#include "srgb.glsl"
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 backbuffer;
layout(push_constant) uniform Params { bool isLinear; } params;

void main() {
    const vec3 color = vec3(uv, 0.25);
    backbuffer = vec4(params.isLinear ? color : srgb_encode(color), 1);
}

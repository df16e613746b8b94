#version 460
#include "area.glsl"
#include "shape/poison.glsl"
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
uniform sampler2D src;
layout(push_constant) uniform Params { vec2 srcUv, srcUvMost; float time; } params;

void main() { color = poisoned(textureLod(src, area_uv(uv, params.srcUv, params.srcUvMost), 0.0), params.time); }

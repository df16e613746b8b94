#version 460
#include "area.glsl"
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 picture;
uniform sampler2D color;
layout(push_constant) uniform Params { vec2 colorUv, colorUvMost; } params;

void main() { picture = texture(color, area_uv(uv, params.colorUv, params.colorUvMost)); }

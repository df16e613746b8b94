#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 picture;
uniform sampler2D base;
layout(push_constant) uniform Params { vec2 colorUv; } params;

void main() { picture = texture(base, uv * params.colorUv); }

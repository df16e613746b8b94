#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 picture;
uniform sampler2D color;

void main() { picture = vec4(uv, 0, 1); }

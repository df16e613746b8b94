#version 460
uniform sampler2D drawn;
uniform sampler2D held;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

void main() { color = texture(drawn, uv) + texture(held, uv); }

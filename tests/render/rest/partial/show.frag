#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
uniform sampler2D noise, table;

void main() { color = vec4(texture(noise, uv).x + texture(table, uv).x); }

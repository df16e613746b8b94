#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
uniform sampler2D src;
void main() { color = texture(src, uv); }

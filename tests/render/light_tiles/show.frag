#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 backbuffer;
uniform sampler2D shown;
void main() { backbuffer = vec4(textureLod(shown, uv, 0.0).rg, 0.0, 1.0); }

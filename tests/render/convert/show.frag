#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 backbuffer;
uniform sampler2D kept, trail, lost;

void main() { backbuffer = (texture(kept, uv) + texture(trail, uv) + texture(lost, uv)) / 3.0; }

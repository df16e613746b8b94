#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 backbuffer;
uniform usampler2D kept;
uniform sampler2D trail;

void main() { backbuffer = texture(trail, uv) + vec4(texture(kept, uv)) / 255.0; }

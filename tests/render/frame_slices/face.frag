#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 backbuffer;
uniform sampler2D probe;

void main() {
    backbuffer = texture(probe, uv) / 255;
}

#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 backbuffer;
uniform sampler2D trail;
uniform usampler2D marks;
uniform sampler2D fresh;
readonly buffer Frames { uint number; } frames;

void main() {
    backbuffer = texture(trail, uv) + texture(fresh, uv) + vec4(frames.number + texture(marks, uv).r) / 255;
}

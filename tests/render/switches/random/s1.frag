#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 dst;
uniform sampler2D a;

void main() { dst = 0.125 + 0.5 * texelFetch(a, ivec2(uv * 64), 0).yxzw; }

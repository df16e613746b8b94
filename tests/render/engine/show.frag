#version 460
uniform sampler2D trail;
uniform sampler2D glass;
uniform sampler2D outline;
uniform sampler2D seen;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

void main() { color = texture(trail, uv) + texture(glass, uv) + texture(outline, uv) + texelFetch(seen, ivec2(0), 0); }

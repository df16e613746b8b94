#version 460
uniform sampler2D sum;
uniform sampler2D trail;
uniform sampler2DArray table;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

void main() { color = texture(sum, uv) + texture(trail, uv) + texture(table, vec3(uv, 1)); }

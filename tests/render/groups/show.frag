#version 460
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 backbuffer;
uniform sampler2DArray baked;

void main() { backbuffer = vec4(texture(baked, vec3(uv, floor(uv.x * 4))).rrr / 4, 1); }

#version 460
#include "material_set.glsl"
layout(location = 0) in vec3 world;
layout(location = 0) out vec4 color;

void main() { color = vec4(material.base_color.rgb * texture(base_color_texture, vec2(0.5)).rgb, 0.5); }

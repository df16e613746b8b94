#version 460
uniform sampler2D paint;
layout(location = 0) in vec4 vertex_tint;
layout(location = 0) out vec4 color;
void main() { color = vertex_tint * texture(paint, gl_FragCoord.xy / 16.0); }

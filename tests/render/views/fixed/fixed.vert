// Places vertices without the matrices of the view, so it draws objects outside of the view too.
#version 460
layout(location = 0) in vec4 position;

void main() { gl_Position = vec4(position.xy * 0.01, 0.5, 1.0); }

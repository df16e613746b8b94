#version 460
layout(location = 0) in vec4 shade;
//                           ^ W205 is expected here
layout(location = 0) out vec4 color;

void main() { color = shade; }

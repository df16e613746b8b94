#version 460
layout(rgba8) writeonly uniform image2D color;

void main() { imageStore(color, ivec2(gl_FragCoord.xy), vec4(0.5)); }

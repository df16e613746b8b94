#version 460
#include "inner.glsl"

layout(location = 0) out vec4 backbuffer;

uniform sampler2D hdr;

void main() { backbuffer = vec4(darkened(texelFetch(hdr, ivec2(gl_FragCoord.xy), 0).rgb), 1.0); }

#version 460
/*here*/#include "nowhere.glsl"

layout(location = 0) out vec4 backbuffer;

uniform sampler2D hdr;

void main() { backbuffer = texelFetch(hdr, ivec2(gl_FragCoord.xy), 0); }

#version 460
layout(location = 0) out vec4 backbuffer;
uniform usampler2D marks, wide;
readonly buffer Words { uint number[]; } words;
readonly buffer Own { uint number[]; } own;

void main() {
    const uint sum = texelFetch(marks, ivec2(0), 0).r + texelFetch(wide, ivec2(0), 0).r;
    backbuffer = vec4((sum + words.number[0] + own.number[0]) & 255u) / 255.0;
}

#version 460
layout(location = 0) out vec4 backbuffer;
uniform usampler2D wide;
readonly buffer Words { uint number[]; } words;
readonly buffer Own { uint number[]; } own;

void main() {
    backbuffer = vec4((texelFetch(wide, ivec2(0), 0).r + words.number[0] + own.number[0]) & 255u) / 255.0;
}

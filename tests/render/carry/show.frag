#version 460
layout(location = 0) out vec4 backbuffer;
readonly buffer Seen { uint words[]; } seen;

void main() { backbuffer = vec4(seen.words[0] & 255u) / 255.0; }

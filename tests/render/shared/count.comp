#version 460
layout(local_size_x = 1) in;
layout(r32ui) uniform uimage2D marks;
layout(r32ui) uniform uimage2D wide;
buffer Words { uint number[]; } words;
buffer Own { uint number[]; } own;

void main() {
    imageStore(marks, ivec2(0), imageLoad(marks, ivec2(0)) + 1u);
    imageStore(wide, ivec2(0), imageLoad(wide, ivec2(0)) + 1u);
    words.number[0] += 1u;
    own.number[0] += 1u;
}

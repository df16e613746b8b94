#version 460
layout(local_size_x = 1) in;
buffer Frames { uint number; } frames;
layout(r32ui) uniform uimage2D marks;
layout(rgba16f) uniform image2D fresh;

void main() {
    frames.number += 1;
    imageStore(marks, ivec2(0), uvec4(max(imageLoad(marks, ivec2(0)).r, 7u)));
    imageStore(fresh, ivec2(0), imageLoad(fresh, ivec2(0)) + 0.25);
}

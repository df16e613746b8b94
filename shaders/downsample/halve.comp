// Purpose: reduces one mip to the next smaller one. downsample.comp makes the same mips in one pass.
#version 460
#include "reduce.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D src;
layout(r32f) writeonly uniform image2D dst;

void main() {
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    const ivec2 size = imageSize(dst);
    if (any(greaterThanEqual(at, size))) return;
    const ivec2 first = covered_first(at), last = covered_last(at, size, textureSize(src, 0));
    float joined = join_nothing();
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) joined = join(joined, texelFetch(src, ivec2(x, y), 0).r);
    imageStore(dst, at, vec4(finish(joined, first, last)));
}

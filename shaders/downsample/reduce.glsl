// Purpose: reduces the texels of one mip that a texel of the next smaller mip covers. Texel p covers the texels
// 2p and 2p + 1 in each direction. If a side is odd, the last texel covers three texels in this direction, so
// that each texel is covered exactly once. Sizes are in texels.
#ifndef WEFT_DOWNSAMPLE_REDUCE
#define WEFT_DOWNSAMPLE_REDUCE

// The reduction: 0 the least texel, 1 the greatest texel, 2 the mean.
layout(constant_id = 1) const int OP = 0;

ivec2 covered_first(ivec2 at) {
    return at * 2;
}

// Returns the last covered texel. `size` and `source` are the sizes of the smaller and of the larger mip.
ivec2 covered_last(ivec2 at, ivec2 size, ivec2 source) {
    return mix(at * 2 + 1, source - 1, equal(at, size - 1));
}

float join(float a, float b) {
    return OP == 0 ? min(a, b) : OP == 1 ? max(a, b) : a + b;
}

float join_nothing() {
    return OP == 0 ? 3.4e38 : OP == 1 ? -3.4e38 : 0.0;
}

float finish(float joined, ivec2 first, ivec2 last) {
    const ivec2 sides = last - first + 1;
    return OP == 2 ? joined / float(sides.x * sides.y) : joined;
}

#endif

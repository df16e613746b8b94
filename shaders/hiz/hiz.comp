// Computes the nearest and the farthest depth in squares of 2 × 2 to 128 × 128 pixels, in one dispatch. Each
// workgroup processes one square of 128 × 128 pixels, so that no workgroup needs the results of another.
// Input depth: reversed, 1 near; 0 is the sky, which is ignored.
// Output mip0 to mip6: r is the largest depth value (nearest), g the smallest (farthest), both without
// the sky. If all pixels of a square are sky, r = 0 and g = 1. Mip k has one texel for each square whose
// side is 2^(k+1) pixels, starting at pixel (0,0). The images cover the picture, rounded up to whole squares
// of 128 × 128 pixels.
#version 460

layout(local_size_x = 16, local_size_y = 16) in;

uniform sampler2D depth;
layout(rg32f) writeonly uniform image2D mip0, mip1, mip2, mip3, mip4, mip5, mip6;

const int kSide1 = 32;  // 128 / 4: texels of mip 1 along the side of a workgroup's square.
const vec2 kSky = vec2(0.0, 1.0);

// Depth ranges of the workgroup's square: all texels of mip 1, then all texels of mip 2, and so on to mip 5.
shared vec2 ranges[kSide1 * kSide1 + 16 * 16 + 8 * 8 + 4 * 4 + 2 * 2];

vec2 merged(vec2 a, vec2 b) { return vec2(max(a.x, b.x), min(a.y, b.y)); }

vec2 range_of(float z) { return z > 0.0 ? vec2(z) : kSky; }

// Returns the depth range of 2 × 2 pixels. If only one row or column is inside the picture, it is read
// twice.
vec2 quad_range(ivec2 first, ivec2 last) {
    if (any(greaterThan(first, last))) return kSky;
    const ivec2 second = min(first + 1, last);
    return merged(merged(range_of(texelFetch(depth, first, 0).r), range_of(texelFetch(depth, second, 0).r)),
                  merged(range_of(texelFetch(depth, ivec2(second.x, first.y), 0).r),
                         range_of(texelFetch(depth, ivec2(first.x, second.y), 0).r)));
}

// Computes mips 0 and 1 for a quarter of the square. Each thread reads 4 × 4 pixels.
void reduce_pixels(ivec2 quarter, ivec2 thread, ivec2 last) {
    const ivec2 in_square = quarter * 16 + thread;
    const ivec2 texel = ivec2(gl_WorkGroupID.xy) * kSide1 + in_square;
    vec2 range = kSky;
    for (int i = 0; i < 4; ++i) {
        const ivec2 quad = texel * 2 + ivec2(i & 1, i >> 1);
        const vec2 of_quad = quad_range(quad * 2, last);
        imageStore(mip0, quad, of_quad.xyxy);
        range = merged(range, of_quad);
    }
    imageStore(mip1, texel, range.xyxy);
    ranges[in_square.y * kSide1 + in_square.x] = range;
}

// Returns the texel `at` of the next mip, from four texels of this mip. The next mip has `side` texels per
// row, this mip 2 × `side`. `from` is the index in `ranges` at which this mip starts.
vec2 next_range(int from, ivec2 at, int side) {
    const int first = from + at.y * 4 * side + at.x * 2;
    return merged(merged(ranges[first], ranges[first + 1]),
                  merged(ranges[first + 2 * side], ranges[first + 2 * side + 1]));
}

void main() {
    const ivec2 thread = ivec2(gl_LocalInvocationID.xy);
    const ivec2 last = textureSize(depth, 0) - 1;
    for (int i = 0; i < 4; ++i) reduce_pixels(ivec2(i & 1, i >> 1), thread, last);
    int from = 0;
    for (int mip = 2; mip <= 6; ++mip) {
        barrier();
        const int side = 128 >> (mip + 1), to = from + 4 * side * side;
        if (all(lessThan(thread, ivec2(side)))) {
            const vec2 range = next_range(from, thread, side);
            const ivec2 texel = ivec2(gl_WorkGroupID.xy) * side + thread;
            if (mip < 6) ranges[to + thread.y * side + thread.x] = range;
            switch (mip) {
                case 2: imageStore(mip2, texel, range.xyxy); break;
                case 3: imageStore(mip3, texel, range.xyxy); break;
                case 4: imageStore(mip4, texel, range.xyxy); break;
                case 5: imageStore(mip5, texel, range.xyxy); break;
                default: imageStore(mip6, texel, range.xyxy);
            }
        }
        from = to;
    }
}

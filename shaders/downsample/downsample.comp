// Purpose: makes up to twelve mips of an image in one dispatch. Each workgroup reduces one block of 64 x 64
// texels to mips 1 to 6. Blocks at the right and lower edge are larger if the size is not a multiple of 64. Then
// the workgroup that finishes last reduces mip 6 to all further mips.
// Dispatch: max(floor(width / 64), 1) x max(floor(height / 64), 1) workgroups. Limit: 8191 texels per side.
#version 460
#include "reduce.glsl"
layout(local_size_x = 256) in;
uniform sampler2D src;                         // Mip 0.
layout(r32f) coherent uniform image2D dst[12];  // Mips 1 to 12, as far as the image has them.
// The number of workgroups that have finished. The buffer keeps its content between frames, and each frame
// begins and ends with 0.
coherent buffer Done { uint finished; } done;
layout(push_constant) uniform Params { int dstCount; vec2 srcSize; } params;

const int kThreads = 256;
const int kBlockLevels = 6;  // A block has 2^6 texels per side.
const int kSide = 63;        // The most texels per side that a block has after the first step.
shared float block_texels[kSide * kSide];
shared bool is_last;

ivec2 level_size(int level) {
    return max(ivec2(params.srcSize) >> level, ivec2(1));
}

float load(int level, ivec2 at) {
    return level == 0 ? texelFetch(src, at, 0).r : imageLoad(dst[kBlockLevels - 1], at).r;
}

void store(int level, ivec2 at, float value) {
    switch (level) {  // The index of an array of images must be a constant.
        case 1: imageStore(dst[0], at, vec4(value)); break;
        case 2: imageStore(dst[1], at, vec4(value)); break;
        case 3: imageStore(dst[2], at, vec4(value)); break;
        case 4: imageStore(dst[3], at, vec4(value)); break;
        case 5: imageStore(dst[4], at, vec4(value)); break;
        case 6: imageStore(dst[5], at, vec4(value)); break;
        case 7: imageStore(dst[6], at, vec4(value)); break;
        case 8: imageStore(dst[7], at, vec4(value)); break;
        case 9: imageStore(dst[8], at, vec4(value)); break;
        case 10: imageStore(dst[9], at, vec4(value)); break;
        case 11: imageStore(dst[10], at, vec4(value)); break;
        case 12: imageStore(dst[11], at, vec4(value)); break;
    }
}

// The texels of one level that belong to a block.
struct Part {
    ivec2 first, sides;
};

// Returns the part of `level` in block `block` of `blocks`, where a block has 64 x 64 texels of level `base`. The
// last block of a row or column includes the rest of the level.
Part part_of(int base, int level, ivec2 block, ivec2 blocks) {
    const int shift = base + kBlockLevels - level;
    const ivec2 first = block << shift;
    return Part(first, mix((block + 1) << shift, level_size(level), equal(block, blocks - 1)) - first);
}

// Returns texel `at` of `level`. `from` is the part of the larger level whose texels are in block_texels. The first
// step reads the larger level from an image instead.
float reduce_texel(int base, int level, ivec2 at, Part from) {
    const ivec2 first = covered_first(at), last = covered_last(at, level_size(level), level_size(level - 1));
    float joined = join_nothing();
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
            const ivec2 inside = ivec2(x, y) - from.first;
            joined = join(joined, level - 1 == base ? load(base, ivec2(x, y))
                                                    : block_texels[inside.y * kSide + inside.x]);
        }
    return finish(joined, first, last);
}

// Reduces a block of level `base` to the levels base + 1 to `top`.
void reduce_block(int base, int top, ivec2 block, ivec2 blocks) {
    const int thread = int(gl_LocalInvocationIndex);
    const int kMost = (kSide * kSide + kThreads - 1) / kThreads;
    for (int level = base + 1; level <= top; ++level) {
        const Part to = part_of(base, level, block, blocks), from = part_of(base, level - 1, block, blocks);
        const int count = to.sides.x * to.sides.y;
        // In block_texels, the new texels replace the texels from which they are made. So all threads make their texels
        // before they store them.
        float made[kMost];
        for (int i = 0; i * kThreads + thread < count; ++i) {
            const int texel = i * kThreads + thread;
            const ivec2 at = to.first + ivec2(texel % to.sides.x, texel / to.sides.x);
            made[i] = reduce_texel(base, level, at, from);
            store(level, at, made[i]);
        }
        barrier();
        for (int i = 0; i * kThreads + thread < count; ++i) {
            const int texel = i * kThreads + thread;
            block_texels[texel / to.sides.x * kSide + texel % to.sides.x] = made[i];
        }
        barrier();
    }
}

// Counts the workgroup as finished. Returns true in the workgroup that finishes last.
bool finishes_last(uint groups) {
    memoryBarrier();  // Mip 6 is written before the workgroup counts as finished.
    barrier();
    if (gl_LocalInvocationIndex == 0u) {
        is_last = atomicAdd(done.finished, 1u) + 1u == groups;
        if (is_last) done.finished = 0u;
    }
    barrier();
    memoryBarrier();
    return is_last;
}

void main() {
    const ivec2 blocks = ivec2(gl_NumWorkGroups.xy);
    [[dont_unroll]] for (int base = 0; base < params.dstCount; base += kBlockLevels) {
        const bool first = base == 0;
        reduce_block(base, min(base + kBlockLevels, params.dstCount), first ? ivec2(gl_WorkGroupID.xy) : ivec2(0),
                     first ? blocks : ivec2(1));
        if (params.dstCount <= kBlockLevels || (first && !finishes_last(uint(blocks.x * blocks.y)))) return;
    }
}

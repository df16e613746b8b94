// Lists that come out sorted, and the same on every run, however threads are timed: in rounds, who enters sets a bit; after
// a barrier the bits before one's own are one's place. For workgroups of 32 threads, which look at four entries each in a
// round, or at one. No subgroup operations, whose sizes differ. All threads call these functions.

const uint kThreads = 32u;
const uint kRound = 4u * kThreads;

// Of this round, of the next, and of the last, which slower threads may still read.
shared uint entering[3][4];
uint round_ = 0u;

// Once, before the first round; somebody else's barrier must follow.
void begin_rounds() {
    if (gl_LocalInvocationIndex < 4u) entering[0][gl_LocalInvocationIndex] = 0u;
}

// Gives the next round's bits their zeros, and this one's to all.
uint close_round() {
    const uint slot = round_ % 3u;
    ++round_;
    if (gl_LocalInvocationIndex < 4u) entering[round_ % 3u][gl_LocalInvocationIndex] = 0u;
    barrier();
    return slot;
}

uint bits_of(bvec4 b) { return uint(b.x) | uint(b.y) << 1 | uint(b.z) << 2 | uint(b.w) << 3; }

// Entries 4 t to 4 t + 3 of a round are for thread t. The place of the first one that enters, the others follow; and how
// many entered.
uint enter_four(bvec4 enters, out uint count) {
    const uint word = gl_LocalInvocationIndex / 8u, shift = gl_LocalInvocationIndex % 8u * 4u;
    if (any(enters)) atomicOr(entering[round_ % 3u][word], bits_of(enters) << shift);
    const uint slot = close_round();
    const uvec4 bits = uvec4(entering[slot][0], entering[slot][1], entering[slot][2], entering[slot][3]);
    const uvec4 counts = uvec4(bitCount(bits));
    count = counts.x + counts.y + counts.z + counts.w;
    const uint before = (word > 0u ? counts.x : 0u) + (word > 1u ? counts.y : 0u) + (word > 2u ? counts.z : 0u);
    return before + uint(bitCount(bits[word] & ((1u << shift) - 1u)));
}

uint enter_one(bool enters, out uint count) {
    const uint own = 1u << gl_LocalInvocationIndex;
    if (enters) atomicOr(entering[round_ % 3u][0], own);
    const uint bits = entering[close_round()][0];
    count = uint(bitCount(bits));
    return uint(bitCount(bits & (own - 1u)));
}

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

// Entry i of a round is for thread i % 32. The places of this thread's entries, and how many entered.
uvec4 enter_four(bvec4 enters, out uint count) {
    const uint own = 1u << gl_LocalInvocationIndex;
    for (uint i = 0u; i < 4u; ++i)
        if (enters[i]) atomicOr(entering[round_ % 3u][i], own);
    const uint slot = close_round();
    const uvec4 bits = uvec4(entering[slot][0], entering[slot][1], entering[slot][2], entering[slot][3]);
    const uvec4 counts = uvec4(bitCount(bits));
    count = counts.x + counts.y + counts.z + counts.w;
    return uvec4(bitCount(bits & (own - 1u))) +
           uvec4(0u, counts.x, counts.x + counts.y, counts.x + counts.y + counts.z);
}

uint enter_one(bool enters, out uint count) {
    const uint own = 1u << gl_LocalInvocationIndex;
    if (enters) atomicOr(entering[round_ % 3u][0], own);
    const uint bits = entering[close_round()][0];
    count = uint(bitCount(bits));
    return uint(bitCount(bits & (own - 1u)));
}

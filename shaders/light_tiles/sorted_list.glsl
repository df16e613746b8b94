// Lists that come out sorted, and the same on every run, however threads are timed: in rounds, who enters sets a bit; after
// a barrier the bits before one's own are one's place. For workgroups of 32 threads, which look at four entries each in a
// round, or at one. No subgroup operations, whose sizes differ. All threads call these functions.
//
// Loops around these rounds, and around all that threads do for long, end at their end: llvmpipe walks what follows a `break`
// once more for nobody. What a loop found is returned from within it, because llvmpipe goes on to change a value that is made
// in a loop and used behind it after a thread has left.

const uint kThreads = 32u;
const uint kPerThread = 4u;
const uint kRound = kPerThread * kThreads;
const uint kWords = kRound / 32u;

// Of this round, of the next, and of the last, which slower threads may still read.
shared uint entering[3][kWords];
shared uint entering_one[3];
uint round_ = 0u, round_of_ones = 0u;

// Once, before the first round; somebody else's barrier must follow.
void begin_rounds() {
    if (gl_LocalInvocationIndex < kWords) entering[0][gl_LocalInvocationIndex] = 0u;
    if (gl_LocalInvocationIndex == 0u) entering_one[0] = 0u;
}

// Entries 4 t to 4 t + 3 of a round are for thread t, which says by bits which enter. What it gives tells the functions below
// of this round, until the next but one.
uint enter_some(uint bits) {
    const uint slot = round_ % 3u;
    if (bits != 0u) atomicOr(entering[slot][gl_LocalInvocationIndex / 8u], bits << gl_LocalInvocationIndex % 8u * 4u);
    ++round_;
    if (gl_LocalInvocationIndex < kWords) entering[round_ % 3u][gl_LocalInvocationIndex] = 0u;
    barrier();
    return slot;
}

uint entered_count(uint slot) {
    uint count = 0u;
    for (uint i = 0u; i < kWords; ++i) count += uint(bitCount(entering[slot][i]));
    return count;
}

// Where in the word the bit is that has so many set ones below it.
uint bit_after(uint word, uint before) {
    uint at = 0u;
    for (uint width = 16u; width > 0u; width /= 2u) {
        const uint count = uint(bitCount(bitfieldExtract(word, int(at), int(width))));
        if (before < count) continue;
        before -= count;
        at += width;
    }
    return at;
}

// The entry of a round that so many enter before; one of the round's in any case.
uint entered_after(uint slot, uint before) {
    uint word = 0u, first = 0u, seen = 0u, seen_before = 0u;
    for (uint i = 0u; i < kWords; ++i) {
        const uint bits = entering[slot][i];
        if (before >= seen) {
            word = bits;
            first = 32u * i;
            seen_before = seen;
        }
        seen += uint(bitCount(bits));
    }
    return first + bit_after(word, before - seen_before);
}

// One entry for each thread. Its place, and how many entered.
uint enter_one(bool enters, out uint count) {
    const uint slot = round_of_ones % 3u, own = 1u << gl_LocalInvocationIndex;
    if (enters) atomicOr(entering_one[slot], own);
    ++round_of_ones;
    if (gl_LocalInvocationIndex == 0u) entering_one[round_of_ones % 3u] = 0u;
    barrier();
    const uint bits = entering_one[slot];
    count = uint(bitCount(bits));
    return uint(bitCount(bits & (own - 1u)));
}

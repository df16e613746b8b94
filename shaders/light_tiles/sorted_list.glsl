// Builds sorted lists that are the same in every run, whatever the timing of threads. It works in rounds: a
// thread that adds an entry sets a bit; after a barrier, the number of lower bits set is the entry's
// position. For workgroups of 32 threads, which test four entries per round, or one. It uses no subgroup
// operations, because subgroup sizes differ. All threads must call these functions.
//
// Loops around these rounds, and long loops of threads, must end at their end: llvmpipe executes the code
// after a `break` once more for inactive threads. A loop's result is returned from inside it, because
// llvmpipe continues to modify variables that are set in a loop and used after it, even for threads that have
// left the loop.

const uint kThreads = 32u;
const uint kPerThread = 4u;
const uint kRound = kPerThread * kThreads;
const uint kWords = kRound / 32u;

// For this round, the next one, and the previous one, which slower threads may still read.
shared uint entering[3][kWords];
shared uint entering_one[3];
uint round_ = 0u, round_of_ones = 0u;

// Call this once before the first round; the caller must add a barrier afterwards.
void begin_rounds() {
    if (gl_LocalInvocationIndex < kWords) entering[0][gl_LocalInvocationIndex] = 0u;
    if (gl_LocalInvocationIndex == 0u) entering_one[0] = 0u;
}

// Thread t tests the entries 4 t to 4 t + 3 of a round; `bits` marks those to add. The result is the slot of
// this round for the functions below; it is valid until two rounds later.
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

// Position in the word of the set bit that has `before` set bits below it.
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

// The round's entry that has `before` added entries before it; if there is none, some entry of the round.
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

// Adds at most one entry per thread. Returns the entry's position and the number of entries added.
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

// Builds sorted lists that are equal in every run, although threads run in any order. The work is done in steps
// ("rounds"). In a round, each thread sets bits for the entries that it adds. After a barrier, the position of an entry
// is the number of set bits below its bit. Workgroups must have 32 threads; in a round, each thread tests four entries
// (enter_some()) or one entry (enter_one()). There are no subgroup operations, because subgroup sizes differ. All
// threads must call these functions.
//
// Write loops around these rounds, and other long loops, so that the exit is at the end of the body:
// llvmpipe executes the code after a `break` once more for inactive threads. Return results from
// inside the loop: llvmpipe continues to change variables of a loop for threads that have already left
// it.

const uint kThreads = 32u;
const uint kPerThread = 4u;
const uint kRound = kPerThread * kThreads;
const uint kWords = kRound / 32u;

// Three sets of bits: for this round, for the next round, and for the previous round, whose set slower
// threads may still read. The sets rotate: round r uses set r % 3.
shared uint entering[3][kWords];
shared uint entering_one[3];
uint round_ = 0u, round_of_ones = 0u;

// Clears the bits of the first round. The caller must execute a barrier before the first round begins.
void begin_rounds() {
    if (gl_LocalInvocationIndex < kWords) entering[0][gl_LocalInvocationIndex] = 0u;
    if (gl_LocalInvocationIndex == 0u) entering_one[0] = 0u;
}

// Does one round. Thread t tests the entries 4 t to 4 t + 3; bit i of `bits` adds the entry 4 t + i. Returns the
// index in `entering` of the set that this round used; the functions below take this index as `slot`. The set
// is cleared two rounds later.
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

// Returns the position of the set bit of the word that has exactly `before` set bits below it.
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

// Returns the index, in this round, of the added entry that has `before` added entries below it. If no entry has so
// many below it, the result is any index in the round.
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

// Does a round with at most one entry per thread. Returns the position of the thread's entry among the added entries.
// `count` receives the number of entries that all threads added.
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

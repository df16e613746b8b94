// Which place each thread's entry gets in a list that is filled in chunks of CHUNK entries, in the threads' order: the same
// on every run. One barrier a chunk; no subgroup operations, whose sizes differ. Once a shader.

const int kWords = (CHUNK + 31) / 32;
// Who enters, as bits: of this chunk, of the next, and of the last, which slower threads may still read.
shared uint entering[3][kWords];
uint round_ = 0u;

// To be called by all threads before the first chunk.
void begin_list() {
    if (gl_LocalInvocationIndex < kWords) entering[0][gl_LocalInvocationIndex] = 0u;
    barrier();
}

// To be called by all threads: the place of this one's entry, if it enters; `listed` grows by all that do.
uint listed_before(bool enters, inout uint listed) {
    const uint now = round_ % 3u, next = (round_ + 1u) % 3u;
    const uint word = gl_LocalInvocationIndex / 32u, bit = gl_LocalInvocationIndex % 32u;
    if (gl_LocalInvocationIndex < kWords) entering[next][gl_LocalInvocationIndex] = 0u;
    if (enters) atomicOr(entering[now][word], 1u << bit);
    barrier();
    uint place = listed;
    for (uint i = 0u; i < kWords; ++i) {
        const uint entries = entering[now][i];
        if (i < word) place += uint(bitCount(entries));
        if (i == word) place += uint(bitCount(entries & ((1u << bit) - 1u)));
        listed += uint(bitCount(entries));
    }
    ++round_;
    return place;
}

// Sums over the invocations of a workgroup, for shaders that write lists without atomics: so the lists are in order and
// equal in every run. Include this file after the size of the workgroup.
#ifndef WEFT_PREFIX_SUM
#define WEFT_PREFIX_SUM

// Up to four counts of each invocation.
shared uvec4 counts[gl_WorkGroupSize.x];

// Replaces the counts of each invocation by the sums over this invocation and all earlier ones. Source: Hillis and
// Steele 1986, "Data Parallel Algorithms".
void sum_counts(uint me) {
    for (uint reach = 1u; reach < gl_WorkGroupSize.x; reach *= 2u) {
        barrier();
        const uvec4 before = me >= reach ? counts[me - reach] : uvec4(0u);
        barrier();
        counts[me] += before;
    }
    barrier();
}
#endif

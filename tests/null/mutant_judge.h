// Purpose: two independent tools judge every broken plan: if a mutant gives wrong results in the null
// executor, the checker must have rejected it. The other cases are printed: rejected by the checker alone, or
// accepted by both.
#pragma once

#include <array>

#include "tests/null/plan_mutants.h"

namespace weft::test {

struct Tally {
    uint32_t all = 0;
    uint32_t caught = 0;     // rejected by the checker
    uint32_t asked = 0;      // run by the null executor
    uint32_t broken = 0;     // with wrong results in the null executor
    uint32_t redundant = 0;  // accepted by both
    uint32_t missed = 0;     // wrong results, but not rejected
};
using Tallies = std::array<Tally, kMutantKinds>;

// The checker is fast; the null executor runs all mutants that the checker accepts, and also every `stride`th
// one. A missed mutant fails the test. With WEFT_SHOW_REDUNDANT set, the function prints the redundant parts
// of plans.
void judge_mutants(const FramePlan& plan, uint32_t stride, Tallies& tallies);
void print(const Tallies& tallies);

}  // namespace weft::test

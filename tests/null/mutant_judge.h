// Purpose: two oracles that know nothing of each other judge every broken plan: what the null executor
// breaks, the checker must have seen. The rest is printed: caught by the checker alone, or redundant to both.
#pragma once

#include <array>

#include "tests/null/plan_mutants.h"

namespace weft::test {

struct Tally {
    uint32_t all = 0;
    uint32_t caught = 0;     // by the checker
    uint32_t asked = 0;      // run by the null executor
    uint32_t broken = 0;     // by it
    uint32_t redundant = 0;  // to both
    uint32_t missed = 0;     // broken, but not caught
};
using Tallies = std::array<Tally, kMutantKinds>;

// The checker is quick; the null executor runs all that it lets through, and every `stride`th besides. A
// mutant that is missed fails the test. With WEFT_SHOW_REDUNDANT set, names what nobody needs.
void judge_mutants(const FramePlan& plan, uint32_t stride, Tallies& tallies);
void print(const Tallies& tallies);

}  // namespace weft::test

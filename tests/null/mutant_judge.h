// Purpose: judges changed plans (mutants) with two independent tools. If a mutant gives wrong results in the
// null executor, the checker must have rejected it. print() also shows how many mutants the checker rejects,
// and how many both tools accept.
#pragma once

#include <array>

#include "tests/null/plan_mutants.h"

namespace weft::test {

struct Tally {
    uint32_t all = 0;
    // Mutants that the checker rejected.
    uint32_t caught = 0;
    // Mutants that the null executor ran.
    uint32_t asked = 0;
    // Mutants that gave wrong results in the null executor.
    uint32_t broken = 0;
    // Mutants that both tools accepted, so the removed part of the plan was redundant.
    uint32_t redundant = 0;
    // Mutants with wrong results that the checker accepted; each one fails the test.
    uint32_t missed = 0;
};
using Tallies = std::array<Tally, kMutantKinds>;

// Judges every `every`th mutant of a plan and adds the results to `tallies`. The checker is fast and judges
// all of these mutants. The null executor runs only the mutants that the checker accepts, and every
// `stride`th of the others. If WEFT_SHOW_REDUNDANT is set, the function prints the redundant parts of plans.
void judge_mutants(const FramePlan& plan, uint32_t stride, Tallies& tallies, uint32_t every = 1);
void print(const Tallies& tallies);

}  // namespace weft::test

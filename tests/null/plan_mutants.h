// Purpose: makes all mutants of a plan. Each mutant removes or weakens one part of the plan's
// synchronisation.
#pragma once

#include <functional>
#include <string>

#include "weft/plan.h"

namespace weft::test {

enum class MutantKind : uint8_t {
    removed_barrier,
    weakened_barrier,
    weakened_prologue,
    removed_wait,
    removed_transfer,
    removed_owner,
    parted_scope,
    other_frames,
};
inline constexpr int kMutantKinds = 8;

struct Mutant {
    MutantKind kind = MutantKind::removed_barrier;
    // Description of the change, for messages.
    std::string text;
    FramePlan plan;
};

// Calls `visit` for every mutant of the plan. Each mutant removes exactly one of these parts: a barrier, one
// stage or access bit of a barrier's source or destination, a semaphore wait, one half of an ownership
// transfer, or one resource that an alias barrier waits for because it used the same memory earlier. One more
// kind of mutant lets a pass begin its own rendering scope, although the plan merges the pass into the scope
// of the pass before it. The new scope has no barrier before it.
// The last kind of mutant records a barrier in all frames instead of only those in which its pass runs, or the
// reverse.
void for_each_mutant(const FramePlan& plan, const std::function<void(const Mutant&)>& visit);

}  // namespace weft::test

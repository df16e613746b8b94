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
};
inline constexpr int kMutantKinds = 7;

struct Mutant {
    MutantKind kind = MutantKind::removed_barrier;
    // Description of the change, for messages.
    std::string text;
    FramePlan plan;
};

// Calls `visit` for every mutant of the plan. A mutant removes a barrier, or one stage or access bit of a
// barrier's source or destination. Or it removes a semaphore wait, one half of an ownership transfer, or one
// previous owner of the memory in an alias barrier. Or a pass that continues a rendering scope gets its own
// scope, without a barrier before it.
void for_each_mutant(const FramePlan& plan, const std::function<void(const Mutant&)>& visit);

}  // namespace weft::test

// Purpose: makes all mutants of a plan: each removes or weakens one piece of its synchronisation.
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
    std::string text;  // description of the change
    FramePlan plan;
};

// Visits every barrier removed, or with one stage or access bit less on either side; every wait removed;
// every half of an ownership transfer removed; every alias barrier without one of its previous owners; every
// pass that continues a rendering scope, put into its own scope without a barrier before it.
void for_each_mutant(const FramePlan& plan, const std::function<void(const Mutant&)>& visit);

}  // namespace weft::test

// Purpose: a plan with one piece of its synchronisation removed or weakened, for every such piece.
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
    std::string text;  // what was done to the plan
    FramePlan plan;
};

// Visits every barrier removed, or weaker by one stage or access bit on either side; every wait removed;
// every half of an ownership transfer removed; every hand-over without one of the owners that it waits for;
// every pass that continues a rendering scope put into one of its own, with no barrier before it.
void for_each_mutant(const FramePlan& plan, const std::function<void(const Mutant&)>& visit);

}  // namespace weft::test

// Purpose: makes all mutants of a plan. Each mutant removes or weakens one part of the plan's
// synchronisation.
#pragma once

#include <functional>
#include <string>

#include "weft/plan.h"

namespace weft::test {

// The part of the plan that a mutant removes or changes.
enum class MutantKind : uint8_t {
    // A barrier that does not transfer ownership between queue families.
    removed_barrier,
    // One stage or access bit of a barrier's source or destination.
    weakened_barrier,
    // Like `weakened_barrier`, for the barriers before and after the plan's prologue.
    weakened_prologue,
    // A semaphore wait.
    removed_wait,
    // One half of an ownership transfer: its release barrier or its acquire barrier.
    removed_transfer,
    // One entry of a barrier's `aliased_from`: a resource that used the same memory earlier.
    removed_owner,
    // The merging of a pass into the rendering scope of the pass before it. The pass begins its own scope,
    // and the mutant adds no barrier before that scope.
    parted_scope,
    // A barrier that is recorded only in frames in which its pass runs is recorded in all frames, or the
    // reverse.
    other_frames,
    // A barrier that all rounds of a group share, and that is recorded in every frame: it moves from the
    // border
    // of the group's passes to the pass next to it.
    moved_barrier,
    // A barrier on several layers or mips of an image, or on several pieces of a buffer, without the last
    // one.
    narrowed_barrier,
};
inline constexpr int kMutantKinds = 10;

struct Mutant {
    MutantKind kind = MutantKind::removed_barrier;
    // Description of the change, for messages.
    std::string text;
    FramePlan plan;
};

// Calls `visit` for every mutant of the plan. Each mutant removes or changes exactly one part (see
// MutantKind).
void for_each_mutant(const FramePlan& plan, const std::function<void(const Mutant&)>& visit);

}  // namespace weft::test

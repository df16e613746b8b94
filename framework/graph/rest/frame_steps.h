// Purpose: lists the steps that a batch records in a frame in which some units do not run. A unit is a set of
// passes with "rest", or a round of a group. The rounds of a group run in a given order.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/plan.h"

namespace weft {

// The parts of a plan's step that are recorded, in this order. A step whose pass runs in every frame is
// recorded as a whole. The steps of a group are divided: the shared barriers of the first step come before
// all rounds, and those of the last step after all rounds.
struct FrameStep {
    Position position = 0;
    bool shared_before = true;  // Records the barriers before the pass that are recorded in every frame.
    bool runs = true;           // Records the pass, and the barriers with BarrierDecl::if_pass_runs.
    bool shared_after = true;   // Records the barriers after the pass that are recorded in every frame.

    // Returns true for the step that only records shared barriers before or after the rounds of a group.
    [[nodiscard]] bool is_border() const { return shared_before != shared_after; }
    // Returns true if the barrier is recorded. `is_before` says whether the barrier is in the list before or
    // after the pass.
    [[nodiscard]] bool records(const BarrierDecl& barrier, bool is_before) const {
        return barrier.if_pass_runs ? runs : (is_before ? shared_before : shared_after);
    }
};

// `runs`: the index is a unit; 1: the unit runs. `rounds`: UnitChoice::rounds. A round that does not run has
// no step, because graphs with light probes have thousands of passes of which only a few run.
[[nodiscard]] std::vector<FrameStep> frame_steps(const FramePlan& plan, const Batch& batch,
                                                 const std::vector<uint8_t>& runs,
                                                 const std::vector<uint32_t>& rounds);

}  // namespace weft

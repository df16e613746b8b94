// Purpose: lists what a batch records in a frame in which some units do not run and the rounds of groups run
// in a given order.
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
    [[nodiscard]] bool is_empty() const { return !shared_before && !runs && !shared_after; }
    // Returns true if the barrier, of the list before or after the pass, is recorded.
    [[nodiscard]] bool records(const BarrierDecl& barrier, bool is_before) const {
        return barrier.if_pass_runs ? runs : (is_before ? shared_before : shared_after);
    }
};

// `runs`: index unit; 1: it runs. `rounds`: UnitChoice::rounds. For each position of the batch, the result
// has one step that is not a border of a group.
[[nodiscard]] std::vector<FrameStep> frame_steps(const FramePlan& plan, const Batch& batch,
                                                 const std::vector<uint8_t>& runs,
                                                 const std::vector<uint32_t>& rounds);

}  // namespace weft

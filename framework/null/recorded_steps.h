// Purpose: lists the steps of a batch in the order in which a frame records them, with the rounds of groups
// in a given order. A round is one copy of all passes of a group; a round that does not run has no step. This
// code does not use the executor's own list (graph/rest/frame_steps.h).
#pragma once

#include <cstdint>
#include <vector>

#include "null/null_executor.h"

namespace weft::null {

struct RecordedStep {
    Position position = 0;
    // A step has three parts: the barriers before the pass that are recorded even if the pass does not run;
    // the pass, with the barriers that are recorded only if it runs; the barriers after the pass that are
    // recorded even if the pass does not run. A member is true if the frame records this part here.
    bool shared_before = true;
    bool runs = true;
    bool shared_after = true;

    [[nodiscard]] bool has(const BarrierDecl& barrier, bool is_before) const {
        return barrier.if_pass_runs ? runs : is_before ? shared_before : shared_after;
    }
};

[[nodiscard]] std::vector<RecordedStep> recorded_steps(const FramePlan& plan, const Batch& batch,
                                                       uint32_t frame, const RestChoice& resting,
                                                       const RoundOrder& rounds);

}  // namespace weft::null

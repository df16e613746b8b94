#include "weft/check/check_plan.h"

#include <algorithm>

#include "check/check_structure.h"
#include "check/replay.h"

namespace weft {

Diagnostics check_plan(const FramePlan& plan) {
    check::FaultList faults(plan);
    if (!check::check_structure(plan, faults)) return faults.take();
    // At least three frames are simulated: the second has a previous frame, and the third shows that the
    // second left every resource in the state in which it found it. A longer history needs more frames until
    // all its copies are written.
    uint32_t history = 0;
    for (const ResourceDecl& resource : plan.graph.resources) history = std::max(history, resource.history);
    check::Replay(plan, faults).run(3 + history);
    return faults.take();
}

}  // namespace weft

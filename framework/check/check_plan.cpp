#include "weft/check/check_plan.h"

#include <algorithm>

#include "check/check_structure.h"
#include "check/replay.h"

namespace weft {

Diagnostics check_plan(const FramePlan& plan) {
    check::FaultList faults(plan);
    if (!check::check_structure(plan, faults)) return faults.take();
    // Three frames: the second has a predecessor, and the third shows that the second restored the initial
    // state. Longer histories need more frames until they are filled.
    uint32_t history = 0;
    for (const ResourceDecl& resource : plan.graph.resources) history = std::max(history, resource.history);
    check::Replay(plan, faults).run(3 + history);
    return faults.take();
}

}  // namespace weft

#include "weft/check/check_plan.h"

#include <algorithm>

#include "check/replay.h"
#include "check/structure/check_structure.h"

namespace weft {

Diagnostics check_plan(const FramePlan& plan) {
    check::FaultList faults(plan);
    if (!check::check_structure(plan, faults)) return faults.take();
    // At least three frames are simulated. The second frame is the first with a previous frame. The third
    // frame starts from the states that the second frame left, so it finds errors if these states are not the
    // planned ones. A resource with `history` n needs n more frames until all its copies are written.
    uint32_t history = 0;
    for (const ResourceDecl& resource : plan.graph.resources) history = std::max(history, resource.history);
    check::Replay(plan, faults).run(3 + history);
    // The barriers do not depend on the switches. But if a pass is switched off, its accesses are missing.
    // The other accesses must still be ordered, and each of them must find content. So all other combinations
    // are simulated, too. The first replay had all switches on.
    const Combination all = (1u << plan.graph.switches.size()) - 1;
    for (Combination combination = 0; combination < all; ++combination)
        check::Replay(plan, faults, combination).run(4 + history);
    return faults.take();
}

}  // namespace weft

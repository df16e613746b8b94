#include "weft/check/check_plan.h"

#include <algorithm>

#include "check/replay.h"
#include "check/structure/check_structure.h"

namespace weft {

Diagnostics check_plan(const FramePlan& plan) {
    check::FaultList faults(plan);
    if (!check::check_structure(plan, faults)) return faults.take();
    // At least three frames are simulated. The second frame is the first with a previous frame. The third
    // frame starts from the states that the second frame left. If these states differ from the states that
    // the plan expects, the third frame gives an error. A resource with `history` n needs n more frames until
    // all its copies are written.
    uint32_t history = 0;
    for (const ResourceDecl& resource : plan.graph.resources) history = std::max(history, resource.history);
    check::Replay(plan, faults).run(3 + history);
    // The barriers do not depend on the switches. But if a switch turns a pass off, the accesses of this pass
    // are missing. The other accesses must still be ordered, and each read must still find content. So all
    // other combinations of switches are simulated, too. In the first replay, all switches were on.
    const Combination all = (1u << plan.graph.switches.size()) - 1;
    for (Combination combination = 0; combination < all; ++combination)
        check::Replay(plan, faults, combination).run(4 + history);
    return faults.take();
}

}  // namespace weft

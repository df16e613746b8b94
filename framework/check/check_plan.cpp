#include "check/check_plan.h"

#include "check/check_structure.h"
#include "check/replay.h"

namespace weft {

Diagnostics check_plan(const FramePlan& plan) {
    check::FaultList faults(plan);
    // Three frames: the second has a frame before it, the third shows that the second left things as it found
    // them.
    if (check::check_structure(plan, faults)) check::Replay(plan, faults).run(3);
    return faults.take();
}

}  // namespace weft

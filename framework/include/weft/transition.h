// Purpose: the one-off plan between two plans, for a resize, a reload or another quality tier: what
// persistent resources carry over, and what starts afresh. Runs once on queue 0, after the last frame of the
// old plan and instead of the new one's prologue. Units: ids of the old plan's resources in `from`, of the
// new plan's everywhere else.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/plan.h"

namespace weft {

// A role of the old plan, as its next frame would find it, becomes the same role of the new plan's first
// frame.
struct CarryOver {
    ResourceId from = kNoId;
    ResourceId to = kNoId;
    // Stretched to a new size, mip by mip (the last old one serves all that are new), with a linear filter,
    // integers with the nearest; else copied as it is.
    bool resample = false;
    bool operator==(const CarryOver&) const = default;
};

struct TransitionPlan {
    std::vector<BarrierDecl> before_old;  // of the old plan's resources: out of their boundary states
    std::vector<BarrierDecl> before;      // of the new plan's: out of undefined
    std::vector<CarryOver> carried;
    std::vector<ResourceId> cleared;  // to their first-frame values
    std::vector<BarrierDecl> after;   // into the states in which the new plan's first frame expects them
    // By ResourceId of the new plan, where it leads a ring: whether the frames counted by the old ring count
    // on.
    std::vector<uint8_t> keeps_validity;
};

[[nodiscard]] TransitionPlan transition(const FramePlan& old_plan, const FramePlan& new_plan);

}  // namespace weft

// Purpose: the transition between two plans, for a resize, a reload or another quality tier: which content of
// persistent resources is kept, and which is initialised again. It runs once on queue 0, after the last frame
// of the old plan and instead of the new plan's prologue. Units: `from` has ids of the old plan's resources,
// all other members of the new plan's.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/plan.h"

namespace weft {

// The content of an old resource, as its next frame would find it, becomes the content of the new resource of
// the same age.
struct CarryOver {
    ResourceId from = kNoId;
    ResourceId to = kNoId;
    // true: scaled to a new size mip by mip (if there are more new mips, from the last old one), with a
    // linear filter, for integers with the nearest texel; false: copied unchanged.
    bool resample = false;
    bool operator==(const CarryOver&) const = default;
};

struct TransitionPlan {
    std::vector<BarrierDecl> before_old;  // for the old plan's resources: from their boundary states
    std::vector<BarrierDecl> before;      // for the new plan's resources: from undefined
    std::vector<CarryOver> carried;
    std::vector<ResourceId> cleared;  // to their first-frame values
    std::vector<BarrierDecl> after;   // to the states that the new plan's first frame expects
    // For each ResourceId of the new plan that is the first of a ring: whether the old ring's count of
    // written frames continues.
    std::vector<uint8_t> keeps_validity;
};

[[nodiscard]] TransitionPlan transition(const FramePlan& old_plan, const FramePlan& new_plan);

}  // namespace weft

// Purpose: finds the rest units of a new plan that compute the same as a unit of the previous plan. A rest
// unit is a set of passes with "rest" that run together, or a round of a group. These units need not run
// again after a resize, a reload or a change of the tier.
#pragma once

#include <functional>
#include <vector>

#include "weft/transition.h"

namespace weft {

// Returns true if two passes have the same pipelines. The arguments are positions in the two plans.
using SamePipelines = std::function<bool(Position old_position, Position new_position)>;

// The units of an older plan that correspond to a unit of the new plan; kNoId if there is none.
struct MatchedUnit {
    uint32_t same = kNoId;  // The old unit with the same passes, declarations and pipelines.
    uint32_t kept = kNoId;  // The old unit with passes of the same names, which may compute something else.
};

// Returns the matches of each unit of `new_plan`. The transition copies the results of all matched units
// unchanged.
[[nodiscard]] std::vector<MatchedUnit> match_units(const FramePlan& old_plan, const FramePlan& new_plan,
                                                   const TransitionPlan& transition,
                                                   const SamePipelines& same_pipelines);

}  // namespace weft

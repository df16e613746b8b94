// Purpose: finds the rest units of a new plan that compute the same as a unit of the plan before it, so that
// they need not run again after a resize, a reload or a change of the tier.
#pragma once

#include <functional>
#include <vector>

#include "weft/transition.h"

namespace weft {

// Returns true if two passes have the same pipelines. The arguments are positions in the two plans.
using SamePipelines = std::function<bool(Position old_position, Position new_position)>;

// Returns for each unit of `new_plan` the unit of `old_plan` that has the same passes with the same
// declarations and pipelines, and whose results the transition copies unchanged; or kNoId.
[[nodiscard]] std::vector<uint32_t> match_units(const FramePlan& old_plan, const FramePlan& new_plan,
                                                const TransitionPlan& transition,
                                                const SamePipelines& same_pipelines);

}  // namespace weft

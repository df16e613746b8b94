// Purpose: finds all alias transitions: the pairs of resources where one takes over memory that the other
// used before. The search goes through the placements of two consecutive frames in time order.
#pragma once

#include <vector>

#include "weft/plan.h"

namespace weft {

// Returns an alias transition for each previous owner of the bytes of every placed transient. Only the second
// of the two frames counts, because all later frames are equal to it. If the previous owner used the bytes in
// the first frame, the transition crosses the frame boundary (`wrap`).
[[nodiscard]] std::vector<AliasTransition> alias_transitions(const std::vector<Placement>& placements,
                                                             const Lifetimes& spans);

}  // namespace weft

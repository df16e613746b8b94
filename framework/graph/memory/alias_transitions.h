// Purpose: finds the pairs of resources of which one takes over memory from the other. It goes through the
// placements of two consecutive frames in time order.
#pragma once

#include <vector>

#include "weft/plan.h"

namespace weft {

// Returns, for every placed transient, the previous owners of its bytes. The result is that of the second of
// the two frames, because all later frames are equal to it. A previous owner in the first frame gives a
// transition across the frame boundary (`wrap`).
[[nodiscard]] std::vector<AliasTransition> alias_transitions(const std::vector<Placement>& placements,
                                                             const Lifetimes& spans);

}  // namespace weft

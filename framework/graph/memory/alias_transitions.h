// Purpose: who takes over whose memory, found by sweeping the placements over two frames in a row.
#pragma once

#include <vector>

#include "weft/plan.h"

namespace weft {

// For every placed transient the owners, byte range by byte range, that held its memory last before it; the
// second of the two frames is what repeats, so that owners from the first are hand-overs across the frame
// boundary.
[[nodiscard]] std::vector<AliasTransition> alias_transitions(const std::vector<Placement>& placements,
                                                             const Lifetimes& spans);

}  // namespace weft

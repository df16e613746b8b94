// Purpose: all barriers of one resource over one frame, from the touches of its subresources alone. What
// happened to its memory before the first touch of a transient is filled in by barriers().
#pragma once

#include <cstdint>
#include <vector>

#include "graph/barrier_state.h"
#include "weft/plan.h"

namespace weft {

struct RangeTouch {
    SubresourceRange range;
    Touch touch;
};

inline constexpr uint32_t kEpiloguePosition = UINT32_MAX;

struct PlacedBarrier {
    uint32_t position = 0;  // or kEpiloguePosition
    BarrierDecl barrier;
};

struct ResourceHistory {
    std::vector<PlacedBarrier> barriers;  // by position
    Pending last;                         // what whoever comes next has to wait for, over all ranges
};

// `touches` in order of position. Imports also get their release into the exit state.
[[nodiscard]] ResourceHistory resource_history(const ResourceDecl& resource,
                                               const std::vector<RangeTouch>& touches);

}  // namespace weft

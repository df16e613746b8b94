// Purpose: finds the passes that a frame needs if only the results of units count: of passes with "rest" and
// of the rounds of groups. Such a frame prepares these results before the first picture.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/plan.h"

namespace weft {

// Index: position in the execution order; 1: the pass belongs to a unit, a unit reads its results, directly
// or through other passes, or it shares a rendering scope with such a pass.
[[nodiscard]] std::vector<uint8_t> needed_by_units(const FramePlan& plan);

}  // namespace weft

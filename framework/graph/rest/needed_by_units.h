// Purpose: some frames come before the first picture and only prepare the results of passes with "rest" and
// of rounds of groups. This file finds the passes that such a frame needs.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/plan.h"

namespace weft {

// Index: position in the execution order; 1: the pass is needed. Needed are the passes of units, the passes
// whose results a needed pass reads or overwrites, and the passes that share a rendering scope with a needed
// pass.
[[nodiscard]] std::vector<uint8_t> needed_by_units(const FramePlan& plan);

}  // namespace weft

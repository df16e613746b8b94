// Purpose: returns texts about passes with switches and about inputs that depend on switches.
#pragma once

#include <string>

#include "weft/plan.h"

namespace weft {

// Describes the combinations of switch values in `set` by the values of as few switches as possible, such as
// `"fog" is on`. Returns an empty text if `set` contains every combination.
[[nodiscard]] std::string describe_combinations(const ResolvedGraph& graph, CombinationSet set);
// Returns the names of the live passes that the switch turns on and off. A pass that runs while the switch is
// off has the mark "!".
[[nodiscard]] std::string switched_passes(const FramePlan& plan, uint32_t switch_id);

}  // namespace weft

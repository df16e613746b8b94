// Purpose: names combinations of switches in messages.
#pragma once

#include <string>
#include <vector>

#include "weft/switches.h"

namespace weft {

// Returns a text such as `"fog" is off`, for a combination in the set. It names the fewest switches that are
// needed: with these values, every combination is in the set. The set must not be empty.
[[nodiscard]] std::string switches_text(const std::vector<SwitchDecl>& switches, CombinationSet set);

}  // namespace weft

// Purpose: finds the rounds of each group, and the round of each pass of a group. Private to expand().
#pragma once

#include "graph/resolve/expand.h"

namespace weft {

// Adds the groups to `expansion`, whose passes are already made. Errors: W109.
void expand_groups(const ResolveInput& input, const Evaluator& evaluator, Expansion& expansion);

}  // namespace weft

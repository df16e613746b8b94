// Purpose: checks that source and target of a copy have the same shape, and that a blit between its source
// and its target is possible.
#pragma once

#include "graph/resolve/version.h"

namespace weft {

// Checks one pass of kind copy or blit. Errors: W183.
void check_copy(const Declared& declared, const VersionedGraph& graph, PassId pass, const Suspects& suspects,
                PassReporter& report);

}  // namespace weft

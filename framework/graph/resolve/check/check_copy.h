// Purpose: checks that both ends of a copy have the same shape, and that the ends of a blit fit.
#pragma once

#include "graph/resolve/version.h"

namespace weft {

// `pass` is one of kind copy. Errors: W183.
void check_copy(const Declared& declared, const VersionedGraph& graph, PassId pass, const Suspects& suspects,
                PassReporter& report);

}  // namespace weft

// Purpose: the stage of resolve() that combines the results of the other stages.
#pragma once

#include "graph/resolve/attach.h"
#include "graph/resolve/fill_blocks.h"
#include "graph/resolve/size_dispatches.h"

namespace weft {

// Does not fill in the parameters of C++ passes and the costs of the graph's parameters, which need the whole
// graph.
[[nodiscard]] ResolvedGraph assemble(const Declared& declared, const VersionedGraph& graph,
                                     const Attachments& attachments, const Dispatches& dispatches,
                                     const Blocks& blocks);

}  // namespace weft

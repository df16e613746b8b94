// Purpose: the stage of resolve() that combines the results of the other stages into one ResolvedGraph.
#pragma once

#include "graph/resolve/attach.h"
#include "graph/resolve/fill_blocks.h"
#include "graph/resolve/size_dispatches.h"

namespace weft {

// Combines the results of the earlier stages. Does not set PassDecl::custom_params and GraphParam::cost,
// because later stages compute them.
[[nodiscard]] ResolvedGraph assemble(const Declared& declared, const VersionedGraph& graph,
                                     const Attachments& attachments, const Dispatches& dispatches,
                                     const Blocks& blocks);

}  // namespace weft

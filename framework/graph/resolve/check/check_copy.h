// Purpose: checks that the source and the target of a copy pass have the same shape. For buffers, this is the
// size in bytes; for images: extent, mips, layers, aspects, samples and bytes per texel. Also checks that the
// source of a blit pass can be blitted to its target.
#pragma once

#include "graph/resolve/version.h"

namespace weft {

// Checks one pass of kind copy or blit. Errors: W183.
void check_copy(const Declared& declared, const VersionedGraph& graph, PassId pass, const Suspects& suspects,
                PassReporter& report);

}  // namespace weft

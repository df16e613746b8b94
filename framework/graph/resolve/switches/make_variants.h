// Purpose: the stage of resolve() that makes the variants of passes whose inputs depend on switches. A
// variant belongs to a set of combinations in which the pass has the same inputs. Each variant has its own
// values of the constants HAS_<port> and of the block Params. Errors: those of fill_blocks().
#pragma once

#include "graph/resolve/version.h"

namespace weft {

[[nodiscard]] ResolvedGraph make_variants(const Declared& declared, const VersionedGraph& versioned,
                                          ResolvedGraph graph, Reporter& reporter);

}  // namespace weft

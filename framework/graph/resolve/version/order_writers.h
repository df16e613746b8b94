// Purpose: puts the writers of each cell in order. Private to version().
#pragma once

#include <vector>

#include "graph/resolve/version/cells.h"

namespace weft {

// Adds the edges of `after`. False if a cycle was reported: then versions are undefined. Errors: W104, W111,
// W150.
[[nodiscard]] bool order_writers(const Declared& declared, VersionedGraph& graph, std::vector<Cell>& cells,
                                 Reporter& reporter);

}  // namespace weft

// Purpose: orders the passes that write each cell. A cell is a part of a resource that every use covers
// completely or not at all. Private to version().
#pragma once

#include <vector>

#include "graph/resolve/version/cells.h"

namespace weft {

// Orders the writers of all cells, and adds the edges of `after` to the graph. Returns false if a cycle was
// reported; then versions are undefined. Errors: W104, W111, W150.
[[nodiscard]] bool order_writers(const Declared& declared, VersionedGraph& graph, std::vector<Cell>& cells,
                                 Reporter& reporter);

}  // namespace weft

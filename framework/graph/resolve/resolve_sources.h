// Purpose: from ordered writers to what each use sees, its final access, and the edges of the graph. Private
// to resolve_*.cpp.
#pragma once

#include <vector>

#include "graph/resolve/resolve_cells.h"

namespace weft {

// The index of the writer whose version `reader` sees in an ordered cell; -1: the content from before the
// frame.
[[nodiscard]] int version_seen(const ResolveState& state, const Cell& cell, const CellUse& reader);
// W110 for reads that nobody writes.
void connect_versions(ResolveState& state, const std::vector<Cell>& cells);
// W124 for reads that, where passes take turns, would not see the version that they name in every frame.
void check_turned_cells(ResolveState& state, const std::vector<Cell>& cells);

}  // namespace weft

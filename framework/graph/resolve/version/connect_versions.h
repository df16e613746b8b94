// Purpose: finds the content that each use sees, its final access, and the edges of the graph, from ordered
// writers. Private to version().
#pragma once

#include <span>
#include <vector>

#include "graph/resolve/version/cells.h"

namespace weft {

// The pins whose versions a pass may see: within its own repeat, only the earlier passes.
[[nodiscard]] std::span<const PassId> visible_pins(const PortDraft& port, PassId pass);
// The index of the writer whose version `reader` sees in an ordered cell; -1: the content from before the
// frame.
[[nodiscard]] int version_seen(const VersionedGraph& graph, const Cell& cell, const CellUse& reader);
// Fills in sources, accesses, states and edges. Errors: W110, for reads of content that no pass writes.
void connect_versions(const Declared& declared, const std::vector<Cell>& cells, VersionedGraph& graph,
                      Reporter& reporter);
// Errors: W124, for reads that, because passes take turns, would not see the version that they name in every
// frame.
void check_turned_reads(const Declared& declared, const std::vector<Cell>& cells, VersionedGraph& graph,
                        Reporter& reporter);

}  // namespace weft

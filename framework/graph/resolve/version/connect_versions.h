// Purpose: finds, from the order of the writers, the content that each use sees, the final access of each
// use, and the edges of the graph. Private to version().
#pragma once

#include <span>
#include <vector>

#include "graph/resolve/version/cells.h"

namespace weft {

// Returns the pinned passes whose versions `pass` may see. If `pass` belongs to the pinned repeat itself,
// these are only the earlier passes of the repeat.
[[nodiscard]] std::span<const PassId> visible_pins(const PortDraft& port, PassId pass);
// Returns the index of the writer whose version `reader` sees in a cell with ordered writers, or -1 if
// `reader` sees the content from before the frame.
[[nodiscard]] int version_seen(const VersionedGraph& graph, const Cell& cell, const CellUse& reader);
// Fills in the sources, accesses and states of all uses, and the edges of the graph. Errors: W110 for reads
// of content that no pass writes.
void connect_versions(const Declared& declared, const std::vector<Cell>& cells, VersionedGraph& graph,
                      Reporter& reporter);
// Checks that each read sees the version that it names in every frame, although passes with `perFrame` run
// only in some frames. Errors: W124.
void check_turned_reads(const Declared& declared, const std::vector<Cell>& cells, VersionedGraph& graph,
                        Reporter& reporter);

}  // namespace weft

// Purpose: finds, from the order of the writers, the content that each use sees, the final access of each
// use, and the edges of the graph. Private to version().
#pragma once

#include <span>
#include <vector>

#include "graph/resolve/version/cells.h"

namespace weft {

// Returns the passes that the `@pass` of the port names. If `pass` itself belongs to the named repeat,
// returns only the passes of the repeat before `pass`, because `pass` cannot see the versions of itself or of
// later passes.
[[nodiscard]] std::span<const PassId> visible_pins(const PortDraft& port, PassId pass);
// Returns which version of a cell (a part of a resource) `reader` sees, as an index into the ordered writers
// of the cell. -1 means the content from before the frame.
[[nodiscard]] int version_seen(const VersionedGraph& graph, const Cell& cell, const CellUse& reader);
// Fills in the sources, accesses and states of all uses, and the edges of the graph. Errors: W110 if a
// use needs content that nothing has written.
void connect_versions(const Declared& declared, const std::vector<Cell>& cells, VersionedGraph& graph,
                      Reporter& reporter);
// Checks that in every frame, each read sees the version that its reference names, although passes with
// `perFrame` run only in some frames. Errors: W124.
void check_sliced_reads(const Declared& declared, const std::vector<Cell>& cells, VersionedGraph& graph,
                        Reporter& reporter);
// Finds what readers see while passes with "switch" are off: fills in UseDecl::passes_on and
// PortDraft::valid_in, and checks that each read has content in all combinations of the switches. Errors:
// W234, W235.
void connect_switched(const Declared& declared, const std::vector<Cell>& cells, VersionedGraph& graph,
                      Reporter& reporter);
// Finds the sets of passes with "rest" that must run together, and fills in VersionedGraph::rest_units.
// Checks that readers see the right content in frames in which these passes do not run. Errors: W188.
void find_rest_units(const Declared& declared, const std::vector<Cell>& cells, VersionedGraph& graph,
                     Reporter& reporter);

// Gives one layout to all reads of an image that units write, and to all reads of an image in a group. A unit
// is a set of passes with "rest" that run together, or a round of a group. Call this function after
// find_rest_units().
void agree_on_layouts(const Declared& declared, const std::vector<Cell>& cells, VersionedGraph& graph);

}  // namespace weft

// Purpose: the rules of groups for the versions of resources. If the round of a pass writes a part of a
// resource, the pass sees the version of its round. If another round of the group writes the part, the pass
// sees the content that the part has when the round of the pass runs. Private to version().
#pragma once

#include <vector>

#include "graph/resolve/version/cells.h"

namespace weft {

// Divides the cells, so that accesses by different rounds are in different cells. Also marks the uses that
// read the results of other rounds (UseDecl::latest). Errors: W190 if several rounds, or a round and a pass
// outside the group, write the same part, or if a pass outside the group uses a resource of the group.
[[nodiscard]] std::vector<Cell> separate_rounds(const Declared& declared, std::vector<Cell> cells,
                                                VersionedGraph& graph, Reporter& reporter);
// Checks that no pass must run between two passes of a group. The edges of the graph must be complete.
// Errors: W190.
void check_group_order(const Declared& declared, VersionedGraph& graph, Reporter& reporter);

}  // namespace weft

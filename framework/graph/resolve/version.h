// Purpose: the stage of resolve() that finds, for each use, the version of the resource that the use sees:
// the content after one particular write. The versions determine the final access of each use and the edges
// between passes. Errors: W104, W110, W111, W124, W150, W188, W190, W234, W235.
#pragma once

#include <vector>

#include "graph/resolve/choose_formats.h"

namespace weft {

struct VersionedGraph {
    std::vector<ResourceDecl> resources;
    // The bound passes, whose uses now have their final access, state and sources.
    std::vector<BoundPass> passes;
    // The dependencies between passes, sorted by (to, from, kind, resource).
    std::vector<EdgeDecl> edges;
    Suspects suspects;
    // Index: PassId. The unit of each pass, or kNoId. A unit is a set of passes that run together; see
    // find_rest_units(). Empty if no pass has "rest" or belongs to a group.
    std::vector<uint32_t> rest_units = {};
    uint32_t rest_unit_count = 0;
    std::vector<GroupDecl> groups = {};  // Sorted by name.
};
// Finds the versions and adds them to the graph. `suspects` comes from the checks after choose_formats().
[[nodiscard]] VersionedGraph version(const Declared& declared, FormattedGraph graph, Suspects suspects,
                                     Reporter& reporter);

}  // namespace weft

// Purpose: the stage of resolve() that finds the version of its resource that each use sees. The final access
// of each use and the edges of the graph follow from it. Errors: W104, W110, W111, W124, W150.
#pragma once

#include <vector>

#include "graph/resolve/choose_formats.h"

namespace weft {

struct VersionedGraph {
    std::vector<ResourceDecl> resources;
    std::vector<BoundPass> passes;  // uses have their final access, state and sources
    std::vector<EdgeDecl> edges;    // sorted by (to, from, kind, resource)
    Suspects suspects;
};
// Extends the graph. `suspects` are those of the checks after choose_formats().
[[nodiscard]] VersionedGraph version(const Declared& declared, FormattedGraph graph, Suspects suspects,
                                     Reporter& reporter);

}  // namespace weft

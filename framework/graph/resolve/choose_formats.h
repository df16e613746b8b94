// Purpose: the stage of resolve() that chooses the format of each image: the first format of its list that
// the device supports for all its usages. Also completes the aspects and the default samplers of all uses.
// The final access, the state and the sources of a use are found later, by version(). Errors: W109, W116,
// W117, W119, W125.
#pragma once

#include <vector>

#include "graph/resolve/bind.h"

namespace weft {

struct FormattedGraph {
    // The resources with their formats, usage flags and aspects.
    std::vector<ResourceDecl> resources;
    std::vector<BoundPass> passes;
    Suspects suspects;
};
// Chooses the formats. Then fills in the parts of each use that depend on the format: the aspects of the
// use's range.
[[nodiscard]] FormattedGraph choose_formats(const Declared& declared, BoundPasses bound, Reporter& reporter);

}  // namespace weft

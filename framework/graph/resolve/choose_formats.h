// Purpose: the stage of resolve() that picks formats. The union of a resource's usages decides: the first
// format that the device supports for all of them. Aspects and default samplers follow from it, and with them
// every use is complete. Errors: W109, W116, W117, W119, W125.
#pragma once

#include <vector>

#include "graph/resolve/bind.h"

namespace weft {

struct FormattedGraph {
    std::vector<ResourceDecl> resources;  // complete
    std::vector<BoundPass> passes;
    Suspects suspects;
};
// Extends the bound passes.
[[nodiscard]] FormattedGraph choose_formats(const Declared& declared, BoundPasses bound, Reporter& reporter);

}  // namespace weft

// Purpose: the stage of resolve() that chooses formats: for each resource, the first format that the device
// supports for all its usages. Aspects and default samplers follow from the format, and then every use is
// complete. Errors: W109, W116, W117, W119, W125.
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

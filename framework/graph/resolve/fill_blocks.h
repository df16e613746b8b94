// Purpose: the stage of resolve() that fills the block `Params` of each shader. Each member gets its value by
// name: from the pass, a parameter or constant of the graph, or a built-in value. Each parameter of the pass
// must be a member of the block. Errors: W106, W107, W113, W178.
#pragma once

#include <vector>

#include "graph/resolve/version.h"

namespace weft {

struct PassBlock {
    std::vector<ParamWrite> params;
    uint32_t bytes = 0;
    bool push_constants = false;
};
struct Blocks {
    // The values of the block of each pass, indexed by PassId.
    std::vector<PassBlock> passes;
    Suspects suspects;
};
[[nodiscard]] Blocks fill_blocks(const Declared& declared, const VersionedGraph& graph, Suspects suspects,
                                 Reporter& reporter);

}  // namespace weft

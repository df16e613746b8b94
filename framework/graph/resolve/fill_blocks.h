// Purpose: the stage of resolve() that fills the block `Params` of each shader. Every member gets its value
// by name from the pass, the graph, a constant or a built-in, and every parameter of the pass must be a
// member. Errors: W106, W107, W113, W178.
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
    std::vector<PassBlock> passes;  // by PassId
    Suspects suspects;
};
[[nodiscard]] Blocks fill_blocks(const Declared& declared, const VersionedGraph& graph, Suspects suspects,
                                 Reporter& reporter);

}  // namespace weft

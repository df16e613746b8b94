// Purpose: the stage of resolve() that fills the block `Params` of each shader. The name of a member
// determines its value: an entry of the pass's key "params", a parameter or constant of the graph, or a
// built-in value such as "time" or "colorSize". Each entry of "params" must name a member of the block.
// Errors: W106, W107, W113, W178.
#pragma once

#include <vector>

#include "graph/resolve/version.h"

namespace weft {

struct PassBlock {
    std::vector<ParamWrite> params;
    uint32_t bytes = 0;           // Size of the block; 0 if the shader has no block.
    bool push_constants = false;  // True for push constants, false for a uniform block.
};
struct Blocks {
    // The values of the block of each pass while all switches are on, indexed by PassId.
    std::vector<PassBlock> passes;
    Suspects suspects;
};
[[nodiscard]] Blocks fill_blocks(const Declared& declared, const VersionedGraph& graph, Suspects suspects,
                                 Reporter& reporter);
// Returns the values of the block of one pass in a combination of the switches. The pass must have a shader.
[[nodiscard]] std::vector<ParamWrite> fill_block(const Declared& declared, const VersionedGraph& graph,
                                                 PassId pass, Combination combination, Reporter& reporter);

}  // namespace weft

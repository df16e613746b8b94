// Purpose: the stage of resolve() that counts the workgroups of compute passes: the counts that the pass
// gives, or else ceil(extent of its output / local size of the shader). Also finds the buffers of indirect
// dispatches and draws, and checks that source and target of each copy fit. Errors: W106, W107, W114, W183.
#pragma once

#include <array>
#include <vector>

#include "graph/resolve/version.h"

namespace weft {

struct PassDispatch {
    std::array<uint32_t, 3> groups{0, 0, 0};
    uint32_t indirect_use = kNoId;
    uint32_t draw_commands_use = kNoId;
};
struct Dispatches {
    // The group counts of each pass, indexed by PassId.
    std::vector<PassDispatch> passes;
    Suspects suspects;
};
[[nodiscard]] Dispatches size_dispatches(const Declared& declared, const VersionedGraph& graph,
                                         Suspects suspects, Reporter& reporter);

}  // namespace weft

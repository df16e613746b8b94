// Purpose: the stage of resolve() that counts workgroups: ceil(extent of the pass's output range / local
// size), or the number given by the pass. It finds the buffers of indirect dispatches and draws, and checks
// that the ends of copies fit. Errors: W106, W107, W114, W183.
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
    std::vector<PassDispatch> passes;  // by PassId
    Suspects suspects;
};
[[nodiscard]] Dispatches size_dispatches(const Declared& declared, const VersionedGraph& graph,
                                         Suspects suspects, Reporter& reporter);

}  // namespace weft

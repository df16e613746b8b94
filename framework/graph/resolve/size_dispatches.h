// Purpose: the stage of resolve() that counts the workgroups of compute passes. The key "groups" of a pass
// gives the counts. Otherwise they are ceil(invocations / local size of the shader), where the key "threads"
// or the extent of the output gives the invocations. This stage also finds the buffers of indirect dispatches
// and draws, and checks that source and target of each copy fit each other. Errors: W106, W107, W114, W183,
// W187, W195.
#pragma once

#include <array>
#include <vector>

#include "graph/resolve/version.h"

namespace weft {

struct PassDispatch {
    std::array<uint32_t, 3> groups{0, 0, 0};
    // Index into the uses of the pass: the buffer with the group counts. kNoId: `groups` has the counts.
    uint32_t indirect_use = kNoId;
    // Index into the uses of the pass: the buffer with the draw commands. kNoId: no indirect draws.
    uint32_t draw_commands_use = kNoId;
    // Index into the uses of the pass: the buffer with the number of draws. kNoId: no such buffer.
    uint32_t draw_count_use = kNoId;
    uint32_t most_draws = 0;  // PassDecl::most_draws.
};
struct Dispatches {
    // The group counts of each pass, or the buffers that contain group counts or draw commands. Indexed by
    // PassId.
    std::vector<PassDispatch> passes;
    Suspects suspects;
};
[[nodiscard]] Dispatches size_dispatches(const Declared& declared, const VersionedGraph& graph,
                                         Suspects suspects, Reporter& reporter);

}  // namespace weft

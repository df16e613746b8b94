// Purpose: resources with both `history` and `keep`. The copy of the current frame ("x") begins a frame with
// the content of the last frame ("x[-1]"). Weft adds the pass "carry:x", which copies this content before
// all other passes that write or read "x". If each part of "x" is overwritten before it is read, the copy is
// not needed, and the pass is removed again. Private to resolve().
#pragma once

#include <map>
#include <string>

#include "graph/resolve/resolve.h"
#include "graph/resolve/shape_resources.h"

namespace weft {

// Returns the carry passes of the graph, by their names. A carry pass copies content of the last frame.
[[nodiscard]] std::map<std::string, PassDesc> describe_carries(const ResolveInput& input,
                                                               const Shapes& shapes);
// Removes the carry passes whose copies no pass needs. Each other carry pass copies the smallest range that
// contains all needed mips and layers. This range may include some mips and layers that are not needed.
[[nodiscard]] ResolvedGraph remove_idle_carries(ResolvedGraph graph);

}  // namespace weft

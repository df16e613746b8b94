// Purpose: finds the passes and resources that a frame needs, so that the others can be left out.
#pragma once

#include <span>
#include <string>

#include "weft/declaration.h"
#include "weft/plan.h"

namespace weft {

// Marks the needed passes and resources as live. If `keep_all` is true, all passes are live. `retained`:
// names of resources that stay live even if no live pass uses them (CompileOptions::retained).
[[nodiscard]] LiveGraph cull(const ResolvedGraph& graph, bool keep_all = false,
                             std::span<const std::string> retained = {});

}  // namespace weft

// Purpose: finds the passes and resources that a frame needs, so that the others can be left out.
#pragma once

#include "weft/declaration.h"
#include "weft/plan.h"

namespace weft {

[[nodiscard]] LiveGraph cull(const ResolvedGraph& graph, bool keep_all = false);

}  // namespace weft

// Purpose: from which position to which each resource is used.
#pragma once

#include "weft/declaration.h"
#include "weft/plan.h"

namespace weft {

[[nodiscard]] Lifetimes lifetimes(const ResolvedGraph& graph, const LiveGraph& live, const Schedule& order);

}  // namespace weft

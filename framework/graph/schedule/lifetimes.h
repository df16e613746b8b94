// Purpose: finds the lifetime of each transient resource: the first and the last schedule position that uses
// the resource.
#pragma once

#include "weft/declaration.h"
#include "weft/plan.h"

namespace weft {

[[nodiscard]] Lifetimes lifetimes(const ResolvedGraph& graph, const LiveGraph& live, const Schedule& order);

}  // namespace weft

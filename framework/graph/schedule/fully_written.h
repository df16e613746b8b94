// Purpose: finds the resources of which a frame writes every mip and layer. The result has 1 for such a
// ResourceId, else 0. If a frame writes only a part of a transient, the other part contains bytes of the
// resource that used the memory before.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/plan.h"

namespace weft {

[[nodiscard]] std::vector<uint8_t> fully_written(const ResolvedGraph& graph, const Schedule& order);

}  // namespace weft

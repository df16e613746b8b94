// Purpose: finds the resources of which a frame writes every mip and layer. The result has 1 for such a
// ResourceId, else 0. The unwritten parts of the other resources still contain bytes of the resource that
// used the same memory before.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/plan.h"

namespace weft {

[[nodiscard]] std::vector<uint8_t> fully_written(const ResolvedGraph& graph, const Schedule& order);

}  // namespace weft

// Purpose: which resources a frame writes in all their parts, by ResourceId. The others hold in some of their
// bytes what the memory's owner before them left there.
#pragma once

#include <cstdint>
#include <vector>

#include "weft/plan.h"

namespace weft {

[[nodiscard]] std::vector<uint8_t> fully_written(const ResolvedGraph& graph, const Schedule& order);

}  // namespace weft

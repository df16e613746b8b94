// Purpose: computes one of the execution orders that the dependencies of a timeline allow.
#pragma once

#include <vector>

#include "null/null_executor.h"
#include "null/timeline.h"

namespace weft::null {

// Returns all nodes. Each node comes once, after all its predecessors.
[[nodiscard]] std::vector<uint32_t> execution_order(const Timeline& timeline, NullOrder order, uint64_t seed);

}  // namespace weft::null

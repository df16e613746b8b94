// Purpose: brings lists of observed cells into one order, so that they can be compared.
#pragma once

#include <vector>

#include "null/null_executor.h"

namespace weft::null {

// Sorts by all members except the value. If a cell was observed several times (by several stages) with
// different values, it gets a new, unique value.
void settle(std::vector<ObservedCell>& observed);

// For each ResourceId, 1 if a live pass uses the resource or any resource of its ring.
[[nodiscard]] std::vector<uint8_t> used_resources(const ResolvedGraph& graph, const LiveGraph& live);

}  // namespace weft::null

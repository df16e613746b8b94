// Purpose: sorts lists of observed cells, so that two runs can be compared.
#pragma once

#include <vector>

#include "null/null_executor.h"

namespace weft::null {

// Sorts by all members except the value. If a cell was observed several times (by several stages) with
// different values, it gets one new, unique value.
void settle(std::vector<ObservedCell>& observed);

// Returns, for each ResourceId, 1 if a live pass uses the resource or another copy of it (a resource of the
// same ring, see ResourceDecl::history), else 0.
[[nodiscard]] std::vector<uint8_t> used_resources(const ResolvedGraph& graph, const LiveGraph& live);

}  // namespace weft::null

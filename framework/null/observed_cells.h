// Purpose: lists of observed cells, in one order.
#pragma once

#include <vector>

#include "null/null_executor.h"

namespace weft::null {

// Sorts by everything but the value. Where one cell was observed several times (by several stages) and not
// with one value, it gets a value of its own.
void settle(std::vector<ObservedCell>& observed);

// By ResourceId: is some role of its ring, or the resource itself, used by a live pass?
[[nodiscard]] std::vector<uint8_t> used_resources(const ResolvedGraph& graph, const LiveGraph& live);

}  // namespace weft::null

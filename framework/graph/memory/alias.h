// Purpose: gives each resource a place in a memory heap. Transient resources that are not alive at the same
// time may share bytes.
#pragma once

#include <cstdint>

#include "weft/compile.h"
#include "weft/declaration.h"
#include "weft/plan.h"

namespace weft {

[[nodiscard]] MemoryPlan alias(const ResolvedGraph& graph, const LiveGraph& live, const Schedule& order,
                               const Lifetimes& spans, const MemoryNeeds& needs, uint64_t granularity_bytes);

}  // namespace weft

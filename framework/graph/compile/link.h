// Purpose: joins the results of all stages to one plan.
#pragma once

#include "graph/sync/synchronize.h"
#include "weft/declaration.h"
#include "weft/plan.h"

namespace weft {

[[nodiscard]] FramePlan link(ResolvedGraph graph, LiveGraph live, Schedule order, const SyncTable& sync,
                             Lifetimes spans, MemoryPlan memory, BarrierPlan barriers,
                             SubmissionPlan submissions);

}  // namespace weft

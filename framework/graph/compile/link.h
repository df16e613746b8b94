// Purpose: combines the results of all compiler stages into one plan.
#pragma once

#include "graph/sync/synchronize.h"
#include "weft/declaration.h"
#include "weft/plan.h"

namespace weft {

struct StageResults {
    ResolvedGraph graph;
    LiveGraph live;
    Schedule schedule;
    SyncTable sync;
    Lifetimes lifetimes;
    MemoryPlan memory;
    BarrierPlan barriers;
    SubmissionPlan submissions;
};

[[nodiscard]] FramePlan link(StageResults results);

}  // namespace weft

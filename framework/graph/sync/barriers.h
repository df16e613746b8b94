// Purpose: all barriers of a frame, those for shared memory among them.
#pragma once

#include <vector>

#include "graph/sync/synchronize.h"
#include "weft/declaration.h"
#include "weft/plan.h"

namespace weft {

// Memory that passes from one queue to another adds to `dependencies`.
[[nodiscard]] BarrierPlan barriers(const ResolvedGraph& graph, const Schedule& order, const SyncTable& sync,
                                   const MemoryPlan& memory,
                                   std::vector<std::vector<AttachmentOps>> attachments,
                                   std::vector<QueueDependency>& dependencies);

}  // namespace weft

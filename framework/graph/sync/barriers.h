// Purpose: all barriers of a frame, those for shared memory among them.
#pragma once

#include <vector>

#include "graph/schedule/attachment_ops.h"
#include "graph/sync/synchronize.h"
#include "weft/declaration.h"
#include "weft/plan.h"

namespace weft {

struct BarrierResult {
    BarrierPlan plan;
    // One for each time that memory passes from one queue to another, besides those of the SyncTable.
    std::vector<QueueDependency> memory_dependencies;
};

[[nodiscard]] BarrierResult barriers(const ResolvedGraph& graph, const Schedule& order, const SyncTable& sync,
                                     const MemoryPlan& memory, const AttachmentTable& attachments);

}  // namespace weft

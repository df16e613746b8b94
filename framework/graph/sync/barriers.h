// Purpose: computes all barriers of a frame, including those for resources that share memory.
#pragma once

#include <vector>

#include "graph/schedule/attachment_ops.h"
#include "graph/sync/synchronize.h"
#include "weft/declaration.h"
#include "weft/plan.h"

namespace weft {

struct BarrierResult {
    BarrierPlan plan;
    // Dependencies between queues that come from shared memory: the new owner of memory must wait for an old
    // owner that used the memory in the previous frame on another queue. SyncTable::dependencies has all
    // other dependencies.
    std::vector<QueueDependency> memory_dependencies;
};

[[nodiscard]] BarrierResult barriers(const ResolvedGraph& graph, const Schedule& order, const SyncTable& sync,
                                     const MemoryPlan& memory, const AttachmentTable& attachments);

}  // namespace weft

// Purpose: computes the barriers and the dependencies between queues that follow from the accesses alone,
// before resources are placed in shared memory.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/sync/scopes.h"
#include "graph/sync/track_resource.h"
#include "weft/declaration.h"
#include "weft/plan.h"

namespace weft {

struct SyncTable {
    HistoryTable histories;  // Index: ResourceId. Barriers and last uses of the resource.
    std::vector<QueueDependency> dependencies;
    // Index: ResourceId. 1 if several queue families use the resource without ownership transfers.
    std::vector<uint8_t> concurrent;
    ScopeTable scopes;  // Neighbouring passes that share one rendering scope.
};
[[nodiscard]] SyncTable synchronize(const ResolvedGraph& graph, const LiveGraph& live, const Schedule& order,
                                    const AttachmentTable& attachments, ScopeTable candidates);
// Returns the schedule with its vector clocks, which it computes from the dependencies between queues.
[[nodiscard]] Schedule add_clocks(Schedule order, const std::vector<QueueDependency>& dependencies);

}  // namespace weft

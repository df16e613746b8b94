// Purpose: the synchronisation that follows from the accesses alone, before memory is shared.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/sync/scopes.h"
#include "graph/sync/track_resource.h"
#include "weft/declaration.h"
#include "weft/plan.h"

namespace weft {

struct SyncTable {
    std::vector<ResourceHistory> histories;  // by ResourceId
    std::vector<QueueDependency> dependencies;
    std::vector<uint8_t> concurrent;  // by ResourceId
    ScopeTable scopes;                // the candidates that no barrier divides
};
[[nodiscard]] SyncTable synchronize(const ResolvedGraph& graph, const Schedule& order,
                                    const AttachmentTable& attachments, ScopeTable candidates);
// The schedule with its clocks, which follow from the waits between queues.
[[nodiscard]] Schedule add_clocks(Schedule order, const std::vector<QueueDependency>& dependencies);

}  // namespace weft

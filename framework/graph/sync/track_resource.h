// Purpose: computes all barriers of one resource in one frame, and its dependencies between queues, from the
// accesses to its subresources alone. barriers() later extends the first barrier of a transient: it must also
// wait for the earlier users of the same memory.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/sync/histories.h"
#include "weft/plan.h"

namespace weft {

// One resource with its accesses. A ring contains all copies of one resource with history: the copy of this
// frame, the copy of one frame ago, and so on. Each copy is a role of the ring.
struct Role {
    const ResourceDecl* decl = nullptr;
    std::span<const RangeAccess> events;  // The accesses to the resource, sorted by schedule position.
};

struct HistoryInput {
    ResourceId resource = kNoId;  // The ring's resource of age 0, or the single resource.
    // The copies of a resource with history form a ring. Index: age, in frames (0: the copy that this frame
    // writes). For a resource without history, the list has one element.
    std::vector<Role> roles;
    const ResolvedGraph* graph = nullptr;
    const Schedule* order = nullptr;
};

struct RingHistory {
    std::vector<ResourceHistory> roles;  // Index: age in the ring, as in HistoryInput::roles.
    std::vector<QueueDependency> dependencies;
    // True if several queue families use the ring without ownership transfers.
    bool concurrent = false;
};

// Adds the last uses of one cell to the last uses of the whole resource. For each queue only the latest
// position is kept, because a semaphore wait for it also covers earlier positions.
void add_last_uses(const std::vector<LastUse>& cell, std::vector<LastUse>& all);
[[nodiscard]] PlacedBarrier placed_barrier(const CellBarrier& barrier, const SubresourceRange& range);

// Computes the barriers and dependencies of a ring or of a single resource. For an import, they include the
// barrier into the exit state at the end of the frame, if one is needed.
[[nodiscard]] RingHistory track_resource(const HistoryInput& input);

}  // namespace weft

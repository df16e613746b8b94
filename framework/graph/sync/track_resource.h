// Purpose: computes all barriers of one resource in one frame, and its dependencies between queues, from the
// accesses to its subresources alone. barriers() later extends the first barrier of a transient: it must also
// wait for the earlier users of the same memory.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/sync/single_queue_tracker.h"
#include "weft/plan.h"

namespace weft {

struct PlacedBarrier {
    // Schedule position at which the barrier is recorded; kEpiloguePosition means the end of the frame.
    Position position = 0;
    bool after = false;  // True if the barrier is recorded after that pass, not before it.
    BarrierDecl barrier;
};

struct ResourceHistory {
    std::vector<PlacedBarrier> barriers;  // The barriers with their positions in the schedule.
    std::vector<LastUse> last_uses;       // The last use on each queue, merged over all subresources.
    // For persistent resources: the layout of each range at the start of a frame. `resource` is not set.
    std::vector<BoundaryState> entry;
};

// One resource with its accesses. The resources of a ring (this frame's copy, the copy of one frame ago, ...)
// are its roles.
struct Role {
    const ResourceDecl* decl = nullptr;
    // The accesses to the resource, sorted by schedule position.
    const std::vector<RangeAccess>* events = nullptr;
};

struct HistoryInput {
    ResourceId resource = kNoId;  // The ring's resource of age 0, or the single resource.
    // The copies of a resource with history form a ring. Index: age, in frames (0: the copy that this frame
    // writes). A resource without history has one element.
    std::vector<Role> roles;
    const Schedule* order = nullptr;
};

struct RingHistory {
    std::vector<ResourceHistory> roles;  // Index: age in the ring, as in HistoryInput::roles.
    std::vector<QueueDependency> dependencies;
    // True if several queue families use the ring without ownership transfers.
    bool concurrent = false;
};

[[nodiscard]] PlacedBarrier placed_barrier(const CellBarrier& barrier, const SubresourceRange& range);

// Computes the barriers and dependencies of a ring or of a single resource. For an import, they include the
// barrier into the exit state at the end of the frame.
[[nodiscard]] RingHistory track_resource(const HistoryInput& input);

}  // namespace weft

// Purpose: all barriers of one resource in one frame, and the dependencies between queues, from the accesses
// to its subresources alone. barriers() adds the earlier users of the memory to the first barrier of a
// transient.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/sync/single_queue_tracker.h"
#include "weft/plan.h"

namespace weft {

struct PlacedBarrier {
    uint32_t position = 0;  // or kEpiloguePosition
    bool after = false;     // recorded after that position's pass
    BarrierDecl barrier;
};

struct ResourceHistory {
    std::vector<PlacedBarrier> barriers;  // by position
    std::vector<LastUse> last_uses;       // over all ranges
    std::vector<BoundaryState> entry;     // persistent resources: how a frame finds them; `resource` not set
};

// A resource, or one role of a ring.
struct Role {
    const ResourceDecl* decl = nullptr;
    const std::vector<RangeAccess>* events = nullptr;  // in order of position
};

struct HistoryInput {
    ResourceId resource = kNoId;  // of the first role
    std::vector<Role> roles;      // all roles of a ring, by age; else the resource alone
    const Schedule* order = nullptr;
};

struct RingHistory {
    std::vector<ResourceHistory> roles;
    std::vector<QueueDependency> dependencies;
    bool concurrent = false;  // used by several families without ownership
};

// Imports also get their release into the exit state.
[[nodiscard]] RingHistory track_resource(const HistoryInput& input);

}  // namespace weft

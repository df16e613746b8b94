// Purpose: computes the history of a resource in the usual case: each access is to the whole resource, and
// the resource is not persistent. track_resource() computes the same result. It allows all cases, but takes
// several times as long.
#pragma once

#include "graph/sync/queue_usage.h"
#include "graph/sync/track_resource.h"

namespace weft {

struct WholeHistory {
    ResourceHistory history;
    std::vector<QueueDependency> dependencies;
    // True if several queue families use the resource without ownership transfers.
    bool concurrent = false;
};

class WholeTracker {
 public:
    explicit WholeTracker(const Schedule& order) : order_(order) {}

    // Returns the history, which is valid until the next call. Returns nullptr if the resource is not in the
    // usual case: it is persistent, or an access is to only a part of it.
    // `events` are the accesses to the resource `id`, sorted by schedule position; there is at least one.
    [[nodiscard]] const WholeHistory* track(ResourceId id, const ResourceDecl& decl,
                                            std::span<const RangeAccess> events);

 private:
    template <class Tracker>
    void run(Tracker tracker, const ResourceDecl& decl);
    void run_on_queues(ResourceId id, const ResourceDecl& decl, const QueueUsage& usage);
    void store(const ResourceDecl& decl);

    const Schedule& order_;
    // Memory for one call. It is kept, so that further calls need no allocations.
    std::vector<AccessEvent> merged_;
    CellSync sync_;
    std::vector<LastUse> last_uses_;
    WholeHistory result_;
};

}  // namespace weft
